// SPDX-License-Identifier: Apache-2.0
// Parses the command line, hands over to a verb, and turns exceptions into messages and exit codes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"
#include "version.hpp"

namespace {

enum ExitCode {
    failure = 1,
    usage = 2,
    no_device = 3,
    kernel_build = 4,
    check_failed = 5,
    interrupted = 130
};

int fail(ExitCode code, const char* message)
{
    fmt::print(stderr, "gonio: {}\n", message);
    return code;
}

int parse(int count, char** words)
{
    CLI::App app{
        "gonio computes how surfaces scatter light: reflectance tables from OpenCL kernels, "
        "checked against "
        "references in double precision.",
        "gonio"};
    app.set_version_flag("--version", GONIO_PROGRAM);
    app.require_subcommand(1);
    gonio::add_devices(app);
    gonio::add_models(app);
    gonio::add_eval(app);
    gonio::add_sample(app);
    gonio::add_table(app);
    gonio::add_run(app);
    gonio::add_plan(app);
    gonio::add_photon(app);
    gonio::add_skin(app);
    gonio::add_picture(app);
    gonio::add_info(app);
    gonio::add_lookup(app);
    gonio::add_compress(app);
    gonio::add_verify(app);
    gonio::add_bench(app);
    try {
        app.parse(count, words);
        return 0;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : usage;
    }
}

}  // namespace

int main(int count, char** words)
try {
    return parse(count, words);
} catch (const gonio::UsageError& error) {
    return fail(usage, error.what());
} catch (const gonio::NoDevice& error) {
    return fail(no_device, error.what());
} catch (const gonio::KernelBuildError& error) {
    return fail(kernel_build, error.what());
} catch (const gonio::CheckFailed& error) {
    return fail(check_failed, error.what());
} catch (const gonio::Interrupted& error) {
    return fail(interrupted, error.what());
} catch (const std::bad_alloc&) {
    return fail(failure, "out of memory");
} catch (const std::exception& error) {
    return fail(failure, error.what());
}
