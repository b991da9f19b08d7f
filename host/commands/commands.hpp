// SPDX-License-Identifier: Apache-2.0
// The verbs of the command line, one file each. A verb adds its subcommand; what it does happens
// when the line is parsed.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "gonio/device.hpp"

namespace gonio {

/// -d and --width, which most verbs have.
struct DeviceOptions {
    std::string device;
    unsigned width = 0;

    void add_to(CLI::App& verb);
    Device open() const;
};

void add_devices(CLI::App& app);
void add_models(CLI::App& app);
void add_eval(CLI::App& app);
void add_sample(CLI::App& app);
void add_table(CLI::App& app);
void add_run(CLI::App& app);
void add_plan(CLI::App& app);
void add_compress(CLI::App& app);
void add_info(CLI::App& app);
void add_lookup(CLI::App& app);
void add_verify(CLI::App& app);
void add_photon(CLI::App& app);
void add_skin(CLI::App& app);
void add_picture(CLI::App& app);
void add_bench(CLI::App& app);

}  // namespace gonio
