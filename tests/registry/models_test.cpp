// SPDX-License-Identifier: Apache-2.0
// Every block of the registry is whole: nothing is named that is not there, no default is refused.
#include "gonio/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gonio/material.hpp"

namespace gonio {
namespace {

TEST(ModelsTest, BlocksAreWhole)
{
    std::set<std::string_view> ids;
    for (const Model& model : models()) {
        SCOPED_TRACE(model.id);
        EXPECT_TRUE(ids.insert(model.id).second) << "twice";
        EXPECT_FALSE(model.title.empty() || model.citation.empty());
        for (const std::string_view note : model.notes) EXPECT_TRUE(note.ends_with('.')) << note;
        for (const Both& both : model.both) {
            EXPECT_EQ(model.index_of(both.alias), Model::npos);
            EXPECT_NE(model.index_of(both.first), Model::npos);
            EXPECT_NE(model.index_of(both.second), Model::npos);
        }
        for (const ParameterAt& at : model.isotropic_at)
            EXPECT_NE(model.index_of(at.name), Model::npos);
    }
}

TEST(ModelsTest, DefaultsAreInTheirRanges)
{
    for (const Model& model : models())
        for (const Parameter& parameter : model.parameters) {
            SCOPED_TRACE(std::string(model.id) + " " + std::string(parameter.name));
            EXPECT_FALSE(parameter.doc.empty());
            EXPECT_LE(parameter.least, parameter.preset);
            EXPECT_LE(parameter.preset, parameter.greatest);
            EXPECT_EQ(parameter.kind == Kind::choice, !parameter.options.empty());
            EXPECT_EQ(parameter.kind == Kind::choice, parameter.unit.empty());
            std::set<std::string_view> names;
            for (const Option& option : parameter.options) {
                EXPECT_TRUE(names.insert(option.name).second) << option.name;
                EXPECT_FALSE(option.doc.empty()) << option.name;
            }
        }
}

// A default that is no option would take the number after the last one.
TEST(ModelsTest, DefaultLobesAreIsotropicAndSet)
{
    for (const Model& model : models()) {
        const Lobe lobe = default_lobe(model.id);
        EXPECT_TRUE(lobe.isotropic()) << model.id;
        for (std::size_t k = 0; k < lobe.values.size(); ++k) {
            const Parameter& parameter = model.parameters[k];
            if (parameter.kind != Kind::choice) continue;
            EXPECT_LT(lobe.values[k][0], static_cast<double>(parameter.options.size()))
                << model.id << " " << parameter.name;
        }
    }
}

TEST(ModelsTest, AliasesNameModelsAndOptions)
{
    for (const Alias& alias : aliases()) {
        EXPECT_EQ(find_model(alias.name), nullptr) << alias.name;
        const Lobe lobe = default_lobe(alias.name);
        EXPECT_EQ(lobe.model->id, alias.model);
        if (alias.choice.empty()) continue;
        const std::size_t index = lobe.model->index_of(alias.choice);
        ASSERT_NE(index, Model::npos) << alias.name;
        const Parameter& choice = lobe.model->parameters[index];
        EXPECT_EQ(choice.options[static_cast<std::size_t>(lobe.values[index][0])].name,
                  alias.option);
    }
    EXPECT_EQ(default_lobe("kmbk").model->id, "vernold_harvey");
}

}  // namespace
}  // namespace gonio
