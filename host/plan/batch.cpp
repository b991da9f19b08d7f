// SPDX-License-Identifier: Apache-2.0
// Makes what is not finished, and keeps the rest.
#include "plan/batch.hpp"

#include <map>
#include <set>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"
#include "output/sidecar.hpp"
#include "output/table_json.hpp"
#include "plan/estimate.hpp"
#include "plan/interrupt.hpp"

namespace gonio {
namespace {

/// Makes the folders that the jobs write to, without leftovers.
void prepare_directories(const std::vector<Job>& jobs)
{
    std::set<std::filesystem::path> directories;
    for (const Job& job : jobs) directories.insert(job.path.parent_path());
    for (const auto& directory : directories) prepare_directory(directory);
}

}  // namespace

bool is_finished(const Job& job)
{
    if (!std::filesystem::is_regular_file(job.path)) return false;
    try {
        return text_of(to_json(read_header(job.path))) == definition(job);
    } catch (const RunError&) {
        return false;
    } catch (const UsageError&) {
        return false;
    }
}

std::vector<const Job*> equal_jobs(const std::vector<Job>& jobs)
{
    std::map<std::pair<std::string, std::string>, const Job*> firsts;
    std::vector<const Job*> equals;
    for (const Job& job : jobs) {
        const auto [place, is_new] = firsts.try_emplace({job.format, definition(job)}, &job);
        equals.push_back(is_new ? nullptr : place->second);
    }
    return equals;
}

BatchReport run_batch(const std::vector<Job>& jobs, const MakeTable& make, Keep keep)
{
    const std::vector<const Job*> equals =
        keep == Keep::finished ? equal_jobs(jobs) : std::vector<const Job*>(jobs.size());
    std::vector<Job> unfinished;
    std::vector<const Job*> twins;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        if (keep == Keep::finished && is_finished(jobs[k])) continue;
        unfinished.push_back(jobs[k]);
        twins.push_back(equals[k]);
    }
    check_disk(unfinished);
    prepare_directories(unfinished);
    double cells = 0;
    for (const Job& job : unfinished) cells += static_cast<double>(job.header.cells());
    Progress progress(cells);
    BatchReport report{0, jobs.size() - unfinished.size()};
    std::map<std::filesystem::path, nlohmann::ordered_json> runs;  // of this run's tables
    for (std::size_t k = 0; k < unfinished.size(); ++k) {
        const Job& job = unfinished[k];
        throw_if_interrupted();
        progress.begin(job.name);
        const Job* twin = twins[k];
        if (twin != nullptr) {
            copy_complete_file(twin->path, job.path);
            progress.advance(static_cast<double>(job.header.cells()));
        } else {
            runs[job.path] = make(job, progress);
        }
        ++(twin != nullptr ? report.copied : report.made);
        write_sidecar(job.path, job.header, runs[twin != nullptr ? twin->path : job.path]);
    }
    return report;
}

}  // namespace gonio
