// SPDX-License-Identifier: Apache-2.0
// Writes MCML's output (.mco), for programs that read it.
#include "photon/mco.hpp"

#include <fmt/format.h>

#include <cmath>

#include "photon/bins.hpp"

namespace gonio {
namespace {

std::string totals(const PhotonResult& result)
{
    double absorbed = result.bottom_absorption.mean;
    std::string layers = "A_l #Absorption as a function of layer. [-]\n";
    for (const Fraction& layer : result.absorption) {
        absorbed += layer.mean;
        layers += fmt::format("{:12.4G}\n", layer.mean);
    }
    return fmt::format(
        "RAT #Reflectance, absorption, transmission. \n{:<14.6G} \t#Specular reflectance [-]\n"
        "{:<14.6G} \t#Diffuse reflectance [-]\n{:<14.6G} \t#Absorbed fraction [-]\n"
        "{:<14.6G} \t#Transmittance [-]\n\n{}\n",
        result.specular.mean, result.diffuse_reflectance.mean, absorbed,
        result.unscattered_transmittance.mean + result.diffuse_transmittance.mean, layers);
}

/// A value for each k below count, one a line.
template <class Value>
std::string column(const char* title, std::size_t count, Value value)
{
    std::string text = std::string(title) + "\n";
    for (std::size_t k = 0; k < count; ++k) text += fmt::format("{:12.4E}\n", value(k));
    return text + "\n";
}

/// value(row, column), five a line.
template <class Value>
std::string matrix(const char* title, std::size_t rows, std::size_t columns, Value value)
{
    std::string text = std::string(title) + "\n";
    for (std::size_t k = 0; k < rows * columns; ++k)
        text += fmt::format("{:12.4E}{}", value(k / columns, k % columns),
                            (k + 1) % 5 == 0 ? "\n" : " ");
    return text + "\n\n";
}

/// Bins [radius][angle] of light that leaves, with those beyond the last radius in one more row.
struct Exits {
    const std::vector<Fraction>& bins;
    const PhotonTallies& tallies;

    double at(std::size_t r, std::size_t a) const { return bins[r * tallies.angles + a].mean; }
    double per_area(std::size_t r) const
    {
        double sum = 0;
        for (std::size_t a = 0; a < tallies.angles; ++a) sum += at(r, a);
        return sum / ring_area(r, tallies.radius_width);
    }
    double per_solid_angle(std::size_t a) const
    {
        double sum = 0;
        for (std::size_t r = 0; r <= tallies.rows; ++r) sum += at(r, a);
        return sum / solid_angle(a, tallies.angles);
    }
    double per_both(std::size_t r, std::size_t a) const
    {
        return at(r, a) / (ring_area(r, tallies.radius_width) * solid_angle(a, tallies.angles));
    }
};

}  // namespace

std::string mco_parameters(const MciRun& run)
{
    const PhotonTallies& bins = run.tallies;
    std::string text = fmt::format(
        "InParm \t# Input parameters. cm is used.\n{} \tA\t# output file name, ASCII.\n"
        "{} \t# No. of photons\n{}\t{}\t# dz, dr [cm]\n{}\t{}\t{}\t# No. of dz, dr, da.\n\n"
        "{} \t# Number of layers\n#n\tmua\tmus\tg\td\t# One line for each layer\n"
        "{} \t# n for medium above.\n",
        run.output, run.photons, bins.depth_width, bins.radius_width, bins.depths, bins.rows,
        bins.angles, run.medium.layers.size(), run.medium.n_above);
    std::size_t number = 0;
    for (const Layer& layer : run.medium.layers)
        text += fmt::format("{}\t{}\t{}\t{}\t{}\t# layer {}\n", layer.n, layer.mua, layer.mus,
                            std::get<HenyeyGreenstein>(layer.phase).g,
                            std::isinf(layer.d) ? 1e8 : layer.d, ++number);
    return text + fmt::format("{} \t# n for medium below.\n\n", run.medium.n_below);
}

std::string mco_text(const MciRun& run, const PhotonResult& result)
{
    const PhotonTallies& bins = run.tallies;
    const Exits up{result.reflected, bins}, down{result.transmitted, bins};
    const auto absorbed = [&](std::size_t z, std::size_t r) {
        return result.absorbed[z * (bins.absorbed_radii + 1) + r].mean;
    };
    const auto absorbed_at_depth = [&](std::size_t z) {
        double sum = 0;
        for (std::size_t r = 0; r <= bins.absorbed_radii; ++r) sum += absorbed(z, r);
        return sum / bins.depth_width;
    };
    std::string text = "A1 \t# Version number of the file format.\n\n";
    text +=
        "####\n# Data categories include: \n# InParm, RAT, \n# A_l, A_z, Rd_r, Rd_a, Tt_r, Tt_a, "
        "\n# A_rz, Rd_ra, Tt_ra \n####\n\n";
    text += mco_parameters(run) + totals(result);
    text += column("A_z #A[0], [1],..A[nz-1]. [1/cm]", bins.depths, absorbed_at_depth);
    text += column("Rd_r #Rd[0], [1],..Rd[nr-1]. [1/cm2]", bins.rows,
                   [&](std::size_t r) { return up.per_area(r); });
    text += column("Rd_a #Rd[0], [1],..Rd[na-1]. [sr-1]", bins.angles,
                   [&](std::size_t a) { return up.per_solid_angle(a); });
    text += column("Tt_r #Tt[0], [1],..Tt[nr-1]. [1/cm2]", bins.rows,
                   [&](std::size_t r) { return down.per_area(r); });
    text += column("Tt_a #Tt[0], [1],..Tt[na-1]. [sr-1]", bins.angles,
                   [&](std::size_t a) { return down.per_solid_angle(a); });
    text += matrix("# A[r][z]. [1/cm3]\n# A[0][0], [0][1],..[0][nz-1]\n# A[1][0], ...\nA_rz",
                   bins.rows, bins.depths, [&](std::size_t r, std::size_t z) {
                       return absorbed(z, r) / (ring_area(r, bins.radius_width) * bins.depth_width);
                   });
    text += matrix(
        "# Rd[r][angle]. [1/(cm2sr)].\n# Rd[0][0], [0][1],..[0][na-1]\n# Rd[1][0], ...\nRd_ra",
        bins.rows, bins.angles, [&](std::size_t r, std::size_t a) { return up.per_both(r, a); });
    text += matrix(
        "# Tt[r][angle]. [1/(cm2sr)].\n# Tt[0][0], [0][1],..[0][na-1]\n# Tt[1][0], ...\nTt_ra",
        bins.rows, bins.angles, [&](std::size_t r, std::size_t a) { return down.per_both(r, a); });
    return text;
}

}  // namespace gonio
