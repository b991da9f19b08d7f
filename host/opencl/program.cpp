// SPDX-License-Identifier: Apache-2.0
// Builds programs from the embedded kernels, or from the folder that GONIO_KERNELS names.
#include "opencl/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>

#include "gonio/errors.hpp"
#include "opencl/embedded.hpp"

namespace gonio {
namespace {

std::string kernel_text(const std::string& path)
{
    if (const char* folder = std::getenv("GONIO_KERNELS")) {
        std::ifstream file(std::filesystem::path(folder) / path);
        if (file) return {std::istreambuf_iterator<char>(file), {}};
    }
    const auto files = kernel_files();
    const auto found = std::ranges::find(files, path, &EmbeddedFile::path);
    if (found == files.end()) throw RunError(fmt::format("there is no kernel file {}", path));
    return std::string(found->text);
}

void flatten(const std::string& text, const std::string& name, std::set<std::string>& included,
             std::string& out)
{
    out += fmt::format("#line 1 \"{}\"\n", name);
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        constexpr std::string_view directive = "#include \"";
        if (!line.starts_with(directive)) {
            out += line + '\n';
            continue;
        }
        const std::string path = line.substr(directive.size(), line.rfind('"') - directive.size());
        if (path.ends_with(".inc") || included.insert(path).second) {
            flatten(kernel_text(path), path, included, out);
            out += fmt::format("#line {} \"{}\"\n", number + 1, name);
        } else {
            out += '\n';
        }
    }
}

std::filesystem::path saved_source(const std::string& source)
{
    auto path = std::filesystem::temp_directory_path() /
                fmt::format("gonio-{:016x}.cl", std::hash<std::string>{}(source));
    std::ofstream(path) << source;
    return path;
}

}  // namespace

std::string flattened(const std::string& text, const std::string& name)
{
    std::set<std::string> included;
    std::string out;
    flatten(text, name, included, out);
    return out;
}

cl::Program build_program(Device::State& device, const std::string& preamble,
                          const std::string& entry, std::vector<std::string> definitions,
                          unsigned width)
{
    definitions.push_back(fmt::format("WIDTH={}", width));
    const std::string options =
        fmt::format("-cl-std=CL1.2 {}-D {}",
                    device.info.correctly_rounded ? "-cl-fp32-correctly-rounded-divide-sqrt " : "",
                    fmt::join(definitions, " -D "));
    const std::string source =
        flattened(fmt::format("{}#include \"{}\"\n", preamble, entry), "program");
    const std::string key = options + '\n' + source;
    if (const auto found = device.programs.find(key); found != device.programs.end())
        return found->second;

    cl::Program program(device.context, source);
    try {
        program.build(device.device, options.c_str());
    } catch (const cl::Error& error) {
        throw KernelBuildError(
            fmt::format("{} does not build on {} ({}): {}\noptions: {}\nsource: {}\n{}", entry,
                        device.info.name, device.info.driver, error_text(error), options,
                        saved_source(source).string(),
                        program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device.device)));
    }
    device.programs.emplace(key, program);
    return program;
}

}  // namespace gonio
