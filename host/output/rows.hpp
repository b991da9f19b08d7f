// SPDX-License-Identifier: Apache-2.0
// What all writers share: rows in order and complete, and conversion in blocks of bounded size.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "gonio/errors.hpp"
#include "gonio/table.hpp"

namespace gonio {

/// Makes a TableWriter of a Format, which has put(Rows<float>), put(Rows<double>) and finish().
template <class Format>
class OrderedWriter final : public TableWriter {
public:
    template <class... Arguments>
    explicit OrderedWriter(const TableHeader& header, Arguments&&... arguments)
        : rows_(header.rows()),
          channels_(header.channels.size()),
          format_(header, std::forward<Arguments>(arguments)...)
    {
    }

    void write(const Rows<float>& rows) override { put(rows); }
    void write(const Rows<double>& rows) override { put(rows); }

    void finish() override
    {
        if (next_ != rows_) {
            throw RunError(fmt::format("a table of {} rows was finished after {}", rows_, next_));
        }
        format_.finish();
    }

private:
    template <class Real>
    void put(const Rows<Real>& rows)
    {
        if (rows.first != next_ || rows.count > rows_ - next_ || rows.planes.size() != channels_) {
            throw RunError(fmt::format("rows {} to {} of {} channels came after row {} of {} of {}",
                                       rows.first, rows.first + rows.count, rows.planes.size(),
                                       next_, rows_, channels_));
        }
        format_.put(rows);
        next_ += rows.count;
    }

    std::size_t rows_;
    std::size_t channels_;
    std::size_t next_ = 0;
    Format format_;
};

/// Calls use(Rows<To>) on consecutive parts of `rows`, converted by To(value): a few MiB at a time,
/// or all of it as it is where nothing needs converting.
template <class To, class From, class Use>
void convert_rows(const Rows<From>& rows, std::size_t row_length, Use use)
{
    if constexpr (std::is_same_v<To, From>) {
        use(rows);
    } else {
        constexpr std::size_t block_values = std::size_t{1} << 18;
        const auto block = std::max<std::size_t>(1, block_values / row_length);
        std::vector<std::vector<To>> scratch(
            rows.planes.size(), std::vector<To>(std::min(block, rows.count) * row_length));
        for (std::size_t done = 0; done < rows.count; done += block) {
            Rows<To> part{rows.first + done, std::min(block, rows.count - done), {}};
            for (std::size_t c = 0; c < rows.planes.size(); ++c) {
                const From* from = rows.planes[c] + done * row_length;
                std::transform(from, from + part.count * row_length, scratch[c].begin(),
                               [](From value) { return static_cast<To>(value); });
                part.planes.push_back(scratch[c].data());
            }
            use(part);
        }
    }
}

}  // namespace gonio
