// SPDX-License-Identifier: Apache-2.0
// gonio compress TABLE: a table of f as a fitted lobe and a residual grid, for model lebedev.
#include "compress/compress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "gonio/errors.hpp"
#include "gonio/residual.hpp"

namespace gonio {
namespace {

struct CompressOptions {
    std::string table, output;
    double error = 1e-3;
    bool json = false;
};

std::string format_of_name(const std::filesystem::path& path)
{
    if (path.extension() == ".exr") return "exr";
    if (path.extension() == ".npy") return "npy";
    throw UsageError(
        fmt::format("{}: the name tells the format; allowed are .exr and .npy", path.string()));
}

void print(const CompressOptions& options, const Lobe& lobe, const Table& table, const Loss& loss)
{
    const auto before = std::filesystem::file_size(options.table);
    const auto after = std::filesystem::file_size(options.output);
    const double ratio = static_cast<double>(before) / static_cast<double>(after);
    const double values = static_cast<double>(table.header.cells() * table.values.size());
    const double ratio_to_float = values * sizeof(float) / static_cast<double>(after);
    nlohmann::ordered_json parameters;
    for (const char* name : {"k_d", "k_s", "alpha"})
        parameters[name] = lobe.values[lobe.model->index_of(name)];
    if (options.json) {
        const nlohmann::ordered_json all{{"table", options.table},
                                         {"output", options.output},
                                         {"lobe", parameters},
                                         {"bytes_before", before},
                                         {"bytes_after", after},
                                         {"ratio", ratio},
                                         {"ratio_to_float32", ratio_to_float},
                                         {"largest_relative_error", loss.largest},
                                         {"rms_relative_error", loss.rms},
                                         {"largest_error_of_maximum", loss.largest_of_maximum}};
        fmt::print("{}\n", all.dump(2));
        return;
    }
    for (const auto& [name, numbers] : parameters.items())
        fmt::print("{:<22} {:.4g}\n", name, fmt::join(numbers.get<std::vector<double>>(), ", "));
    fmt::print("{:<22} {} to {} bytes: 1/{:.1f}, and 1/{:.1f} of float32 values\n", "size", before,
               after, ratio, ratio_to_float);
    fmt::print("{:<22} {:.2g} largest, {:.2g} root mean square\n", "relative error", loss.largest,
               loss.rms);
    fmt::print("{:<22} {:.2g} of the greatest value\n", "absolute error", loss.largest_of_maximum);
}

void compress_file(const CompressOptions& options)
{
    if (!(options.error >= 0 && options.error <= 0.5))
        throw UsageError(fmt::format("--error is {}; allowed is 0 to 0.5", options.error));
    const std::string format = format_of_name(options.output);
    const Table table = read_residual_table(options.table);
    write_table(options.output, format, compress(table, options.table, options.error));
    Lobe lobe = default_lobe("lebedev");
    lobe.set("residual", options.output);
    print(options, lobe, table, loss_of(lobe, table));
}

}  // namespace

void add_compress(CLI::App& app)
{
    CLI::App* verb = app.add_subcommand(
        "compress", "Make a fitted lobe and a residual grid of a table, for model lebedev");
    const auto options = std::make_shared<CompressOptions>();
    verb->add_option("TABLE", options->table,
                     "f over theta_h, theta_d, phi_d: --kind rusinkiewicz, or a MERL .binary")
        ->required();
    verb->add_option("-o,--output", options->output, "file: .exr, or .npy, which is not packed")
        ->required();
    verb->add_option("--error", options->error,
                     "relative error of f that rounding the residual may cause");
    verb->add_flag("--json", options->json, "Print JSON");
    verb->callback([options] { compress_file(*options); });
}

}  // namespace gonio
