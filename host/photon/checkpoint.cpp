// SPDX-License-Identifier: Apache-2.0
// What a simulation needs to go on, in a file beside its table until that is finished.
#include "photon/checkpoint.hpp"

#include <fstream>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"

namespace gonio {

using nlohmann::ordered_json;

Checkpoint::Checkpoint(const std::filesystem::path& table, std::string definition)
    : path_(table.string() + ".checkpoint"), definition_(std::move(definition))
{
}

ordered_json Checkpoint::progress() const
{
    std::ifstream file(path_, std::ios::binary);
    const auto saved = ordered_json::from_cbor(file, true, false);
    const bool fits = saved.is_object() && saved.value("definition", "") == definition_;
    return fits ? saved.value("progress", ordered_json()) : ordered_json();
}

void Checkpoint::save(const ordered_json& progress)
{
    std::string bytes;
    ordered_json::to_cbor(ordered_json{{"definition", definition_}, {"progress", progress}}, bytes);
    write_file(path_, bytes);
    last_ = std::chrono::steady_clock::now();
}

bool Checkpoint::is_due() const
{
    return std::chrono::steady_clock::now() - last_ > std::chrono::seconds(20);
}

void Checkpoint::remove() const
{
    std::filesystem::remove(path_);
}

ordered_json state_of(const PhotonTracer& tracer)
{
    const std::string state = tracer.state();
    return ordered_json::binary({state.begin(), state.end()});
}

void restore(PhotonTracer& tracer, const ordered_json& state)
{
    const auto& bytes = state.get_binary();
    tracer.restore({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace gonio
