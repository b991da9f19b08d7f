// SPDX-License-Identifier: Apache-2.0
// From a material to its reference: fills the parameter structs and adds up the lobes.
#include "gonio/material.hpp"
#include "reference/params.hpp"

namespace gonio {
namespace reference {
namespace {

double as_asked(double number, Parameters parameters)
{
    return parameters == Parameters::rounded ? static_cast<float>(number) : number;
}

/// Hands out a lobe's numbers in the order of the registry's block.
class Reader {
public:
    Reader(const Lobe& lobe, Parameters parameters) : lobe_(lobe), parameters_(parameters) {}
    double scalar() { return as_asked(lobe_.number(next_++, 0), parameters_); }
    Color color()
    {
        Color all{};
        const std::size_t count = lobe_.values[next_].size();
        for (std::size_t c = 0; c < max_channels; ++c)
            all[c] = as_asked(lobe_.number(next_, c < count ? c : 0), parameters_);
        ++next_;
        return all;
    }
    std::shared_ptr<const ResidualGrid> table() { return lobe_.table(next_++); }
    template <class Choice>
    Choice choice()
    {
        return static_cast<Choice>(static_cast<int>(lobe_.values[next_++][0]));
    }

private:
    const Lobe& lobe_;
    Parameters parameters_;
    std::size_t next_ = 0;
};

// ward_params read_ward(const Lobe& lobe, ...): braces are read from left to right.
#define MODEL(id, title, citation, traits)                         \
    id##_params read_##id(const Lobe& lobe, Parameters parameters) \
    {                                                              \
        Reader read(lobe, parameters);                             \
        return                                                     \
        {
#define SCALAR(id, name, unit, least, greatest, preset, doc) read.scalar(),
#define COLOR(id, name, unit, least, greatest, preset, doc) read.color(),
#define TABLE(id, name, doc) read.table(),
#define CHOICE(id, name, preset, doc) read.choice<id##_##name>(),
#define END_MODEL(id) \
    }                 \
    ;                 \
    }
#include "gonio/shared/models.inc"

Reference bind(const Lobe& lobe, Parameters parameters)
{
#define MODEL(name, title, citation, traits)                                                       \
    if (lobe.model->id == #name)                                                                   \
        return                                                                                     \
            [p = read_##name(lobe, parameters)](glm::dvec3 l, glm::dvec3 v, std::size_t channel) { \
                return name(p, l, v, channel);                                                     \
            };
#include "gonio/shared/models.inc"
    return {};
}

double weight(const Lobe& lobe, std::size_t channel, Parameters parameters)
{
    return as_asked(lobe.weight[lobe.weight.size() == 1 ? 0 : channel], parameters);
}

/// 0 for models without a mirror term.
double specular(const Lobe& lobe, glm::dvec3 l, std::size_t channel)
{
#define SPECULAR(name)           \
    if (lobe.model->id == #name) \
        return name##_specular(read_##name(lobe, Parameters::rounded), l, channel);
#include "gonio/shared/models.inc"
    return 0;
}

}  // namespace
}  // namespace reference

Reference make_reference(const Material& material, Measure measure, Parameters parameters)
{
    struct Term {
        Reference f;
        Lobe lobe;
        bool is_value;
    };
    std::vector<Term> terms;
    for (const Lobe& lobe : material.lobes)
        terms.push_back({reference::bind(lobe, parameters), lobe, (lobe.traits() & VALUE) != 0});
    return [terms, measure, parameters](glm::dvec3 l, glm::dvec3 v, std::size_t channel) {
        double sum = 0;
        for (const Term& term : terms) {
            double f = reference::weight(term.lobe, channel, parameters) * term.f(l, v, channel);
            if (measure == Measure::brdf && term.is_value) f /= l.z;
            if (measure == Measure::brdf_cosine && !term.is_value) f *= l.z;
            sum += f;
        }
        return sum;
    };
}

double specular_reflectance(const Material& material, glm::dvec3 l, std::size_t channel)
{
    double sum = 0;
    for (const Lobe& lobe : material.lobes)
        sum += reference::weight(lobe, channel, Parameters::rounded) *
               reference::specular(lobe, l, channel);
    return sum;
}

}  // namespace gonio
