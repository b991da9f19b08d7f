// SPDX-License-Identifier: Apache-2.0
// The parameters behind the names of tests/data.
#include "skin/skin_fixtures.hpp"

#include <map>
#include <utility>
#include <vector>

namespace gonio::test {

Skin skin_of(const std::string& name)
{
    using Parameters = std::vector<std::pair<std::string, double>>;
    static const std::map<std::string, std::pair<std::string, Parameters>> all{
        {"jacques1998_light", {"jacques_1998", {{"melanin", 0.038}}}},
        {"jacques1998_moderate", {"jacques_1998", {{"melanin", 0.135}}}},
        {"jacques1998_dark", {"jacques_1998", {{"melanin", 0.305}}}},
        {"pyxopto_2layer", {"pyxopto", {}}},
        {"donnerjensen2006_a",
         {"donner_jensen_2006", {{"blood", 0.005}, {"melanin", 0.01}, {"melanin_blend", 0.7}}}},
        {"donnerjensen2006_b",
         {"donner_jensen_2006", {{"blood", 0.01}, {"melanin", 0.1}, {"melanin_blend", 0.7}}}},
        {"donnerjensen2006_c",
         {"donner_jensen_2006", {{"blood", 0.05}, {"melanin", 0.3}, {"melanin_blend", 0.9}}}},
        {"meglinski2001_600nm", {"meglinski_2001", {}}},
        {"meglinski2002_A", {"meglinski_2002", {{"melanin", 0.1}}}},
        {"meglinski2002_A_mel2", {"meglinski_2002", {{"melanin", 0.02}}}},
        {"meglinski2002_B", {"meglinski_2002", {{"melanin", 0.1}, {"gamma", 1}}}},
        {"delgado2011_bil0", {"delgado_2011", {{"bilirubin", 0}}}},
        {"delgado2011_bil0.1", {"delgado_2011", {{"bilirubin", 0.1}}}},
        {"delgado2011_bil0.25", {"delgado_2011", {{"bilirubin", 0.25}}}}};
    const auto& [model, parameters] = all.at(name);
    Skin skin(find_skin_model(model));
    for (const auto& [parameter, value] : parameters) skin.set(parameter, value);
    return skin;
}

SumOfGaussians skin_of_gpu_gems()
{
    return {{0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41},
            {{0.233, 0.455, 0.649},
             {0.100, 0.336, 0.344},
             {0.118, 0.198, 0},
             {0.113, 0.007, 0.007},
             {0.358, 0.004, 0},
             {0.078, 0, 0}}};
}

}  // namespace gonio::test
