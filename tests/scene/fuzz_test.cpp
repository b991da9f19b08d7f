// SPDX-License-Identifier: Apache-2.0
// Broken scenes by the thousand: each is read and planned, or refused with a UsageError.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <random>

#include "gonio/errors.hpp"
#include "gonio/job.hpp"

namespace gonio {
namespace {

const std::string layered = R"([[material]]
name = "forearm"
n_below = 1.4
bottom = "open"
layers = [ { mua = 0.2, mus = 1000, g = 0.9, n = 1.53, d = 0.002 }, { mua = 0.7, mus = 200 } ]
[[table]]
material = "forearm"
quantity = "reflectance_r"
axes = { r = { to = 2.0, count = 200 } }
max_error = 1e-3
time = "5 s"
)";

std::vector<std::string> seeds()
{
    std::vector<std::string> texts{layered};
    for (const auto name : {"quickstart", "brushed_steel", "merl", "face_phong", "face_skin"}) {
        std::ifstream file(std::string(SCENES) + "/" + name + ".toml");
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// Changes one thing of a text.
class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t count) { return random_() % count; }

    void mutate(std::string& text)
    {
        static constexpr std::array tokens = {"0",
                                              "-1",
                                              "nan",
                                              "-inf",
                                              "1e308",
                                              "65536",
                                              "65537",
                                              "9223372036854775807",
                                              "1e-320",
                                              "\"\"",
                                              "\"x\"",
                                              "[]",
                                              "{}",
                                              "[[]]",
                                              "=",
                                              "\n",
                                              "[[table]]\n",
                                              "[[material]]\n",
                                              "[a.b]\n",
                                              "true",
                                              "1979-05-27",
                                              "'''",
                                              "\\u0000",
                                              "\xff",
                                              "{ from = 0.1, to = 1, count = 9 }",
                                              "{ values = [1, 2], as = \"files\" }",
                                              "\"node\"",
                                              "\"rusinkiewicz\"",
                                              "#",
                                              "\xe2\x82\xac"};
        const auto at = below(text.size() + 1);
        switch (below(24)) {
            case 0:
                text.insert(at, tokens[below(tokens.size())]);
                break;
            case 1:
                text.erase(at, below(20));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size() + 1), below(200)));
                break;
            case 3:
                text.resize(at);
                break;
            case 4:
                if (at < text.size()) text[at] = static_cast<char>(random_());
                break;
            default:
                replace_value(text, below(3) == 0 ? tokens[below(tokens.size())] : value_of(text));
        }
    }

private:
    /// Begin and length of what stands behind a random equals sign; of nothing if there is none.
    std::pair<std::size_t, std::size_t> find_value(const std::string& text)
    {
        const auto equals = text.find('=', below(text.size() + 1));
        if (equals == std::string::npos) return {0, 0};
        const auto end = std::min(text.find_first_of(",}\n", equals), text.size());
        return {equals + 1, end - equals - 1};
    }

    std::string value_of(const std::string& text)
    {
        const auto [begin, length] = find_value(text);
        return text.substr(begin, length);
    }

    void replace_value(std::string& text, const std::string& value)
    {
        const auto [begin, length] = find_value(text);
        text.replace(begin, length, value);
    }

    std::mt19937 random_;
};

/// No more than this many bytes of address space above what the process has now.
class MemoryLimit {
public:
    explicit MemoryLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_AS, &before_);
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        auto limit = before_;
        limit.rlim_cur = pages * 4096 + bytes;
        ::setrlimit(RLIMIT_AS, &limit);
    }
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before_); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

private:
    rlimit before_ = {};
};

TEST(FuzzedScene, IsPlannedOrRefusedWithAUsageError)
{
    const auto texts = seeds();
    const MemoryLimit limit(rlim_t{512} << 20);
    int planned = 0, refused = 0, not_toml = 0;
    for (unsigned seed = 0; seed < 10000; ++seed) {
        Mutator mutator(seed);
        std::string text = texts[seed % texts.size()];
        for (auto changes = 1 + mutator.below(3); changes > 0; --changes) mutator.mutate(text);
        try {
            plan_jobs(parse_scene(text, "scene.toml"));
            ++planned;
        } catch (const UsageError& fault) {
            EXPECT_EQ(std::string(fault.what()).rfind("scene.toml:", 0), 0U) << fault.what();
            ++(std::string_view(fault.what()).find("not TOML") == std::string::npos ? refused
                                                                                    : not_toml);
        } catch (const std::exception& fault) {
            ADD_FAILURE() << fault.what() << "\nin seed " << seed << ":\n" << text;
        }
    }
    // All of it is reached: the parser, the checks and the planner.
    EXPECT_GT(not_toml, 1000);
    EXPECT_GT(refused, 1000);
    EXPECT_GT(planned, 300);
}

}  // namespace
}  // namespace gonio
