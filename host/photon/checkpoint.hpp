// SPDX-License-Identifier: Apache-2.0
// What a simulation needs to go on, in a file beside its table until that is finished.
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "gonio/photons.hpp"

namespace gonio {

class Checkpoint {
public:
    /// definition: all that the bytes of the table depend on.
    Checkpoint(const std::filesystem::path& table, std::string definition);

    /// What was saved with the same definition; null if nothing was.
    nlohmann::json progress() const;
    /// Puts a tracer into the state of then. Only where there is progress.
    void restore(PhotonTracer& tracer) const;

    void save(const nlohmann::json& progress, const PhotonTracer& tracer);
    bool is_due() const;  ///< the last one is some time ago
    void remove() const;

private:
    nlohmann::json load() const;

    std::filesystem::path path_;
    std::string definition_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace gonio
