// SPDX-License-Identifier: Apache-2.0
// gonio info FILE: axes, channels, conventions, range and parameters of a table.
#include <fmt/format.h>

#include "commands/commands.hpp"
#include "output/describe.hpp"

namespace gonio {

void add_info(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "info", "Say what a table holds: axes, channels, conventions, range, parameters");
    const auto path = std::make_shared<std::string>();
    const auto json = std::make_shared<bool>(false);
    verb->add_option("FILE", *path, "any table that gonio wrote, or a MERL .binary")->required();
    verb->add_flag("--json", *json, "Print JSON");
    verb->callback([path, json] {
        const Description description = describe(*path);
        fmt::print("{}\n", *json ? to_json(description).dump(2) : text_of(description));
    });
}

}  // namespace gonio
