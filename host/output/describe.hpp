// SPDX-License-Identifier: Apache-2.0
// What `gonio info` says about a file, gathered without holding the table in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gonio/table.hpp"

namespace gonio {

/// Over the finite values of a channel; NaN if there is none.
struct ChannelRange {
    double min = std::numeric_limits<double>::quiet_NaN();
    double max = std::numeric_limits<double>::quiet_NaN();
    double mean = std::numeric_limits<double>::quiet_NaN();
    std::size_t not_finite = 0;  ///< NaN and infinite values; in MERL files, cells without a value
};

struct Description {
    std::string format;  ///< exr, npy, csv, merl
    TableHeader header;
    std::vector<ChannelRange> ranges;  ///< one for each channel
};

/// Reads the whole file once, a few MiB at a time. Throws as read_table.
Description describe(const std::filesystem::path& path);

/// Several lines for people.
std::string text_of(const Description& description);

/// The same for programs: format, table (table_json.hpp), ranges by channel.
nlohmann::ordered_json to_json(const Description& description);

}  // namespace gonio
