// SPDX-License-Identifier: Apache-2.0
// The one type of everything gonio computes: named axes x named channels x values.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

/// Where a value sits on its axis: in the middle of a cell, or on a node (the first and last node
/// are the end points).
enum class Samples { centre, node };

/// One axis of a table. `values` are the sample positions in `unit`, finite and strictly monotonic.
struct Axis {
    std::string name;
    std::string unit;
    std::vector<double> values;
    Samples samples = Samples::centre;
};

using Attribute = std::variant<double, std::string, std::vector<double>>;

/// Everything about a table but its values. Axes run from the outermost to the innermost (fastest).
/// A row is one run of the innermost axis; rows are counted in row-major order of the other axes.
/// Names are unique and free of commas, quotes and control characters; attribute numbers are finite
/// (writers refuse others with a UsageError).
struct TableHeader {
    std::string quantity;  ///< a name of quantities.inc
    std::string unit;      ///< unit of the values, e.g. "1/sr"
    std::vector<Axis> axes;
    std::vector<std::string> channels;  ///< e.g. "R", "G", "B", or "Y" if there is one
    std::size_t sweep_axes = 0;         ///< how many leading axes are swept; never the innermost
    bool single_precision = true;       ///< float32 values; else float64
    std::vector<std::pair<std::string, Attribute>> attributes;  ///< in the order they are written

    std::size_t row_length() const;  ///< values in a row
    std::size_t rows() const;        ///< rows of one channel; UsageError if they cannot be counted
    std::size_t cells() const;       ///< rows() * row_length(); UsageError as above
    const Attribute* find(const std::string& name) const;  ///< nullptr if there is none
};

/// A whole table in memory. values[channel][row * row_length + column]; a standard error or an
/// error bound is a channel of its own, named after its channel with ".error" behind it.
struct Table {
    TableHeader header;
    std::vector<std::vector<double>> values;
};

/// Rows [first, first + count) of every channel: planes[channel] points at count * row_length
/// values.
template <class Real>
struct Rows {
    std::size_t first = 0;
    std::size_t count = 0;
    std::vector<const Real*> planes;
};

/// Writes a table to a temporary file beside `path`; nothing is visible under `path` before
/// finish(). Rows come in ascending order, each exactly once. The destructor removes what was not
/// finished.
class TableWriter {
public:
    virtual ~TableWriter() = default;
    virtual void write(const Rows<float>& rows) = 0;
    virtual void write(const Rows<double>& rows) = 0;
    /// Completes the file, flushes it to the disk and renames it to its final name. Throws
    /// RunError.
    virtual void finish() = 0;
};

struct WriteOptions {
    bool half = false;                ///< EXR only: 16-bit floats
    std::string compression = "zip";  ///< EXR only: none, rle, zips, zip, piz
};

/// The formats: "exr", "npy", "csv", "merl". Throws UsageError for an unknown one and for a table
/// that a format cannot hold (MERL: anything but a 90 x 90 x 180 Rusinkiewicz table at bin
/// centres), RunError where the disk refuses.
std::unique_ptr<TableWriter> make_writer(const std::filesystem::path& path,
                                         const std::string& format, const TableHeader& header,
                                         const WriteOptions& options = {});

/// Writes a table that is in memory.
void write_table(const std::filesystem::path& path, const std::string& format, const Table& table,
                 const WriteOptions& options = {});

/// Only the header, without reading the values.
TableHeader read_header(const std::filesystem::path& path);

/// Reads any file that a writer made, and any MERL .binary. The format is told by content, not by
/// name.
Table read_table(const std::filesystem::path& path);

}  // namespace gonio
