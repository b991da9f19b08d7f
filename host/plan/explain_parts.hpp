// SPDX-License-Identifier: Apache-2.0
// Plans in words, by what a job is of.
#pragma once

#include "plan/explain.hpp"

namespace gonio {

void leave_out(JobPlan& plan, std::string what, std::string why,
               std::optional<double> saving = std::nullopt);

/// Part of a whole is left out, so that the work is about so much less, if all parts are alike.
void leave_out_part(JobPlan& plan, const char* of, std::size_t all, std::size_t left,
                    std::string why, bool alike = true);

void explain_layers(JobPlan& plan, const Device& device, const Job& job);
void explain_skin(JobPlan& plan, const Device& device, const Job& job);

}  // namespace gonio
