// SPDX-License-Identifier: Apache-2.0
// Every model of the registry against its reference on the device, extremes included; and that a
// wrong kernel is found.
#include "verify/verify.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

class Verify : public testing::TestWithParam<Model> {};

TEST_P(Verify, KeepsTheBound)
{
    const Device device;
    const Verdict verdict = verify_model(device, GetParam(), true);
    EXPECT_TRUE(verdict.passed()) << "relative " << verdict.accuracy.relative << " of allowed "
                                  << verdict.bound << ", not finite " << verdict.accuracy.not_finite
                                  << ", negative " << verdict.negative << ", reciprocity "
                                  << verdict.reciprocity_defect << ", with " << verdict.worst;
    EXPECT_GT(verdict.accuracy.checked, 1000U);
}

INSTANTIATE_TEST_SUITE_P(Registry, Verify, testing::ValuesIn(models()),
                         [](const auto& model) { return std::string(model.param.id); });

/// A folder of kernels in which one file differs, for the life of the object.
class Kernels {
public:
    Kernels(const std::string& file, const std::string& text)
        : folder_(std::filesystem::temp_directory_path() /
                  ("gonio-kernels-" + std::to_string(getpid())))
    {
        std::filesystem::create_directories((folder_ / file).parent_path());
        std::ofstream(folder_ / file) << text;
        setenv("GONIO_KERNELS", folder_.c_str(), 1);
    }
    ~Kernels()
    {
        unsetenv("GONIO_KERNELS");
        std::filesystem::remove_all(folder_);
    }

private:
    std::filesystem::path folder_;
};

TEST(WrongKernel, IsFound)
{
    const Kernels kernels("brdf/lambert.cl",
                          "#include \"core/lobe.cl\"\n"
                          "static inline void lambert_eval(const lambert_params *p, const "
                          "directions *d, real f[CHANNELS])\n"
                          "{ FOR_CHANNELS(c) f[c] = (real)(p->rho[c] / PI * R(1.001)); }\n");
    const Verdict verdict = verify_model(Device(), *find_model("lambert"), true);
    EXPECT_FALSE(verdict.passed());
    EXPECT_NEAR(verdict.accuracy.relative, 1e-3, 1e-6);
}

TEST(WrongKernel, ThatDoesNotBuildSaysWhere)
{
    const Kernels kernels("brdf/lambert.cl", "#include \"core/lobe.cl\"\nthis is no OpenCL\n");
    try {
        verify_model(Device(), *find_model("lambert"), true);
        FAIL() << "it built";
    } catch (const KernelBuildError& error) {
        EXPECT_NE(std::string(error.what()).find("brdf/lambert.cl:2"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace gonio
