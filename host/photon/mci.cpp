// SPDX-License-Identifier: Apache-2.0
// Reads MCML's input files (.mci), line by line; # begins a comment, empty lines do not count.
#include "photon/mci.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <system_error>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

// What MCML calls infinite: its own files give 1e8 cm to semi-infinite media.
constexpr double infinite_from = 1e8;
constexpr std::uint64_t most_bins = std::uint64_t{1} << 24, most_layers = 1000, most_runs = 100'000;

class MciReader {
public:
    MciReader(std::string_view text, std::string file)
        : text_(std::string(text)), file_(std::move(file))
    {
    }

    std::vector<MciRun> read()
    {
        if (next("the version 1.0 of the file")[0] != "1.0")
            fail(fmt::format("the version of the file is `{}`; this program reads 1.0", words_[0]));
        const std::uint64_t runs = whole(next("the number of runs")[0], most_runs);
        std::vector<MciRun> all;
        for (std::uint64_t k = 0; k < runs; ++k) all.push_back(read_run());
        return all;
    }

private:
    [[noreturn]] void fail(const std::string& message) const
    {
        throw UsageError(fmt::format("{}:{}: {}", file_, line_, message));
    }

    /// The words of the next line that has some.
    const std::vector<std::string>& next(const std::string& what, std::size_t count = 1)
    {
        std::string text;
        while (std::getline(text_, text)) {
            ++line_;
            std::istringstream words(text.substr(0, text.find('#')));
            words_.assign(std::istream_iterator<std::string>(words), {});
            if (words_.empty()) continue;
            if (words_.size() < count)
                fail(fmt::format("expected {}, and found {} of {} values", what, words_.size(),
                                 count));
            return words_;
        }
        fail(fmt::format("the file ends where {} is expected", what));
    }

    double number(const std::string& word) const
    {
        double value = 0;
        const char* const end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error != std::errc() || stop != end || !std::isfinite(value))
            fail(fmt::format("`{}` is not a number", word));
        return value;
    }

    std::uint64_t whole(const std::string& word, std::uint64_t most) const
    {
        const double value = number(word);
        if (!(value >= 1 && value <= static_cast<double>(most) && value == std::floor(value)))
            fail(fmt::format("{} must be a whole number from 1 to {}", word, most));
        return static_cast<std::uint64_t>(value);
    }

    double above_zero(const std::string& word) const
    {
        const double value = number(word);
        if (!(value > 0)) fail(fmt::format("{} must be above 0", word));
        return value;
    }

    MciRun read_run()
    {
        MciRun run;
        run.output = next("the name of the output and A", 2)[0];
        check_output(run.output);
        if (words_[1] != "A")
            fail(fmt::format("output in the format `{}`: this program writes A (ASCII) only",
                             words_[1]));
        run.photons = whole(next("the number of photons")[0], std::uint64_t{1} << 53);
        PhotonTallies& tallies = run.tallies;
        tallies.reflected = tallies.transmitted = tallies.absorbed = true;
        next("dz and dr", 2);
        tallies.depth_width = above_zero(words_[0]);
        tallies.radius_width = above_zero(words_[1]);
        next("the numbers of dz, dr and da", 3);
        tallies.depths = whole(words_[0], most_bins);
        tallies.rows = tallies.absorbed_radii = whole(words_[1], most_bins);
        tallies.angles = whole(words_[2], most_bins);
        const std::uint64_t layers = whole(next("the number of layers")[0], most_layers);
        run.medium.n_above = number(next("n of the medium above")[0]);
        for (std::uint64_t k = 0; k < layers; ++k) run.medium.layers.push_back(read_layer());
        run.medium.n_below = number(next("n of the medium below")[0]);
        check(run.medium);
        return run;
    }

    void check_output(const std::string& name)
    {
        if (name.find('/') != std::string::npos || name.front() == '.')
            fail(fmt::format("`{}` must be a file's name without a folder", name));
        if (!outputs_.insert(name).second)
            fail(fmt::format("another run of this file writes `{}` too", name));
    }

    Layer read_layer()
    {
        next("n, mua, mus, g and d of a layer", 5);
        Layer layer{.mua = number(words_[1]),
                    .mus = number(words_[2]),
                    .n = number(words_[0]),
                    .d = number(words_[4]),
                    .phase = HenyeyGreenstein{number(words_[3])}};
        if (layer.d >= infinite_from) layer.d = INFINITY;
        return layer;
    }

    void check(const LayeredMedium& medium) const
    {
        try {
            validate(medium);
        } catch (const UsageError& fault) {
            fail(fmt::format("the layers that end here: {}", fault.what()));
        }
    }

    std::istringstream text_;
    std::string file_;
    std::size_t line_ = 0;
    std::set<std::string> outputs_;
    std::vector<std::string> words_;
};

}  // namespace

std::vector<MciRun> parse_mci(std::string_view text, const std::string& file)
{
    return MciReader(text, file).read();
}

std::vector<MciRun> load_mci(const std::filesystem::path& path)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file || std::filesystem::is_directory(path))
        throw UsageError(fmt::format("{}: cannot be read: {}", path.string(),
                                     std::generic_category().message(errno)));
    return parse_mci(text, path.string());
}

}  // namespace gonio
