// SPDX-License-Identifier: Apache-2.0
// What is saved: the values of the sets that are finished, and the state of the one at hand.
#include "skin/traced_sets.hpp"

#include "photon/checkpoint.hpp"
#include "skin/skin_sets.hpp"

namespace gonio {

using nlohmann::ordered_json;

TracedSets trace_sets(const Job& job, const std::function<void(double)>& after_each,
                      const TraceSet& trace)
{
    const auto sets = sets_of(*job.skin);
    TracedSets all{.table = {job.header, {}}};
    all.table.values.resize(job.header.channels.size());
    Checkpoint checkpoint(job.path, definition(job));
    const ordered_json saved = checkpoint.progress();
    ordered_json from;
    if (!saved.is_null()) {
        all.table.values = saved.at("values").get<std::vector<std::vector<double>>>();
        all.beside = saved.at("beside");
        from = saved.at("set");
    }
    for (std::size_t set = all.beside.size(); set < sets.size(); ++set) {
        const auto after_launch = [&](double part, const std::function<ordered_json()>& state) {
            const auto save = [&] {
                checkpoint.save(
                    {{"values", all.table.values}, {"beside", all.beside}, {"set", state()}});
            };
            try {
                after_each((static_cast<double>(set) + part) / static_cast<double>(sets.size()));
            } catch (...) {
                save();
                throw;
            }
            if (checkpoint.is_due()) save();
        };
        all.beside.push_back(trace(sets[set], all.table, from, after_launch));
        from = nullptr;
    }
    return all;
}

}  // namespace gonio
