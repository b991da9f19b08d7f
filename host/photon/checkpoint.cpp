// SPDX-License-Identifier: Apache-2.0
// What a simulation needs to go on, in a file beside its table until that is finished.
#include "photon/checkpoint.hpp"

#include <fstream>

#include "gonio/errors.hpp"
#include "output/atomic_file.hpp"

namespace gonio {

Checkpoint::Checkpoint(const std::filesystem::path& table, std::string definition)
    : path_(table.string() + ".checkpoint"), definition_(std::move(definition))
{
}

nlohmann::json Checkpoint::load() const
{
    std::ifstream file(path_, std::ios::binary);
    const auto saved = nlohmann::json::from_cbor(file, true, false);
    const bool fits = saved.is_object() && saved.value("definition", "") == definition_;
    return fits ? saved : nlohmann::json::object();
}

nlohmann::json Checkpoint::progress() const
{
    return load().value("progress", nlohmann::json());
}

void Checkpoint::restore(PhotonTracer& tracer) const
{
    const auto bytes = load().at("tracer").get_binary();
    tracer.restore({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void Checkpoint::save(const nlohmann::json& progress, const PhotonTracer& tracer)
{
    const std::string state = tracer.state();
    std::string bytes;
    nlohmann::json::to_cbor(
        nlohmann::json{{"definition", definition_},
                       {"progress", progress},
                       {"tracer", nlohmann::json::binary({state.begin(), state.end()})}},
        bytes);
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

}  // namespace gonio
