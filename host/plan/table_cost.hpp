// SPDX-License-Identifier: Apache-2.0
// What tables on larger grids will take.
#pragma once

namespace gonio {

/// What a table took.
struct TableSeconds {
    double all = 0, checking = 0;
};

/// Every table takes some seconds, however small; each cell takes some, and each value that is
/// compared with the reference: all of them in small tables, and the same number in all large ones.
class TableCost {
public:
    /// As a table of so many cells took it, and one of next to none `small` seconds.
    TableCost(double small, const TableSeconds& taken, double cells, double channels);

    /// How many of a table's cells so many seconds are enough for.
    double cells_in(double seconds) const;

private:
    double compared_of(double cells) const;

    double small_, channels_, cell_, compared_;
};

}  // namespace gonio
