// SPDX-License-Identifier: Apache-2.0
// Media that files of tests/data/layers describe.
#include "reference/layer_fixtures.hpp"

#include "reference/layered_media.hpp"

namespace gonio::test {

LayeredMedium slab_of(const CsvRow& row)
{
    const double albedo = row.number("a");
    return in_air({layer(row.number("n"), 1 - albedo, albedo, row.number("g"), row.number("b"))});
}

std::map<std::string, LayeredMedium> skin_models()
{
    std::map<std::string, LayeredMedium> models;
    for (const CsvRow& row : read_csv("layers/skin_layers.csv")) {
        LayeredMedium& medium = models[row.text("model") + "," + row.text("lambda_nm")];
        medium.n_below = row.text("model").starts_with("delgado") ? 1.5 : 1.4;
        medium.layers.push_back(layer(row.number("n"), row.number("mua"), row.number("mus"),
                                      row.number("g"), row.number("d")));
    }
    return models;
}

}  // namespace gonio::test
