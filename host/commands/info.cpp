// SPDX-License-Identifier: Apache-2.0
// gonio info FILE: axes, channels, conventions, range and parameters of a table.
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "output/describe.hpp"
#include "output/table_plot.hpp"

namespace gonio {
namespace {

struct InfoOptions {
    std::string path, plot;
    bool json = false;
};

void info(const InfoOptions& options)
{
    const Description description = describe(options.path);
    if (!options.plot.empty()) write_table_plot(options.plot, read_table(options.path));
    fmt::print("{}\n", options.json ? to_json(description).dump(2) : text_of(description));
}

}  // namespace

void add_info(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "info", "Say what a table holds: axes, channels, conventions, range, parameters");
    const auto options = std::make_shared<InfoOptions>();
    verb->add_option("FILE", options->path, "any table that gonio wrote, or a MERL .binary")
        ->required();
    verb->add_flag("--json", options->json, "Print JSON");
    verb->add_option("--plot", options->plot,
                     "PNG or SVG of a table of one axis, with its errors, or of two");
    verb->callback([options] { info(*options); });
}

}  // namespace gonio
