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
    nlohmann::ordered_json progress() const;

    void save(const nlohmann::ordered_json& progress);
    bool is_due() const;  ///< the last one is some time ago
    void remove() const;

private:
    std::filesystem::path path_;
    std::string definition_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A tracer as a part of what is saved.
nlohmann::ordered_json state_of(const PhotonTracer& tracer);
/// Puts a tracer into the state of then.
void restore(PhotonTracer& tracer, const nlohmann::ordered_json& state);

}  // namespace gonio
