// SPDX-License-Identifier: Apache-2.0
// What leaving out saves: scenes as they are planned, and computed the general way.
#include <fmt/format.h>

#include "gonio/compute.hpp"
#include "gonio/job.hpp"
#include "gonio/photons.hpp"
#include "photon/asked_layers.hpp"
#include "photon/bins.hpp"
#include "photon/exact_values.hpp"
#include "plan/batch.hpp"
#include "timings/sections.hpp"
#include "timings/skin.hpp"

namespace gonio {
namespace {

constexpr double asked = 1e-3;       // of the totals of skin, relative
constexpr std::size_t thetas = 256;  // fewer take milliseconds, most of them not for values
constexpr std::string_view exchanged = "totals of skin to 1e-3";

/// A scene, and how long each way takes.
struct Contest {
    std::string name;
    std::function<double()> planned, general;
};

/// lobes: of the one material; its table is asked for `times`.
Contest of_tables(const BenchRun& run, const std::string& name, const std::string& lobes, int times)
{
    std::string text = fmt::format("[[material]]\nname = \"m\"\nlobes = [{}]\n", lobes);
    for (int k = 0; k < times; ++k)
        text += fmt::format(
            "[[table]]\nmaterial = \"m\"\nname = \"t{0}\"\nquantity = \"brdf\"\n"
            "grid = {{ kind = \"isotropic\", theta_i = {1}, theta_o = {1}, "
            "delta_phi = 720 }}\n",
            k, thetas);
    const auto jobs = std::make_shared<std::vector<Job>>(plan_jobs(parse_scene(text, name)));
    const auto timed = [&run, jobs](bool leave_out) {
        return seconds_on_the_wall([&] {
            const std::vector<const Job*> twins = equal_jobs(*jobs);
            for (std::size_t k = 0; k < jobs->size(); ++k)
                if (!leave_out || twins[k] == nullptr)
                    compute_grid(run.device, (*jobs)[k].materials[0], Measure::brdf,
                                 (*jobs)[k].grid, [](const Rows<float>&) {},
                                 {.leave_out = leave_out});
        });
    };
    timed(true);
    timed(false);
    return {name, [timed] { return timed(true); }, [timed] { return timed(false); }};
}

/// A table of skin where blood absorbs most.
Job at_420_nm(const std::string& table)
{
    return plan_jobs(parse_scene("[[material]]\nname = \"m\"\nskin = \"meglinski_2002\"\n"
                                 "wavelength = 420\n[[table]]\nmaterial = \"m\"\n" +
                                     table,
                                 "layers"))
        .front();
}

/// Down to the layers that light comes back from.
Contest of_layers()
{
    const Job job = at_420_nm("quantity = \"mean_albedo\"\nmax_error = 1e-4\n");
    const auto timed = [job](bool leave_out) {
        return seconds_on_the_wall([&] {
            LightJob light = *job.layers;
            if (leave_out) light.medium = asked_layers(job).medium;
            exact_values(light, job.header.axes);
        });
    };
    return {"skin at 420 nm", [timed] { return timed(true); }, [timed] { return timed(false); }};
}

/// The same by photons, as many either way.
Contest of_photons(const BenchRun& run)
{
    const Job job = at_420_nm(
        "quantity = \"reflectance_alpha\"\nsolver = \"monte_carlo\"\nmax_error = 1e-2\n"
        "axes = { alpha = { to = 90, count = 9 } }\n");
    const auto timed = [job, &run](bool leave_out) {
        return seconds_on_the_wall([&] {
            const LightJob& light = *job.layers;
            PhotonTracer tracer(
                run.device, leave_out ? asked_layers(job).medium : light.medium,
                {.light = light.light, .tallies = tallies_of(*light.quantity, job.header.axes)});
            tracer.trace(run.quick ? 1 << 18 : 1 << 20);
        });
    };
    timed(true);
    timed(false);
    return {"by photons at 420 nm", [timed] { return timed(true); },
            [timed] { return timed(false); }};
}

/// Adding-doubling in place of as many photons as have the same error.
Contest of_skin(const BenchRun& run)
{
    const LayeredMedium medium = benchmark_skin();
    const auto exact = [medium] {
        return seconds_on_the_wall(
            [&] { reference::solve_layers_to(medium, {.incidence = {0}}, asked); });
    };
    const auto photons = [medium, &run] {
        PhotonTracer tracer(run.device, medium, {.batch = 256});
        tracer.trace(1 << 16);
        const Fraction rd = tracer.result().diffuse_reflectance;
        const double off = rd.error / rd.mean / asked;
        return tracer.kernel_seconds() * off * off;
    };
    photons();
    return {std::string(exchanged), exact, photons};
}

Quartiles sum(const Quartiles& a, const Quartiles& b)
{
    return {a.median + b.median, a.low + b.low, a.high + b.high};
}

}  // namespace

BenchPlot bench_savings(const BenchRun& run)
{
    BenchPlot plot{"savings", "What leaving out saves",
                   "Scenes as they are planned, and the general way, by the wall's clock, without "
                   "files: BRDFs of 256 x 256 x 720 cells over the whole turn; photons as many "
                   "as have the error asked for, by the error that a known number of them has. "
                   "Batches: the sums of scenes, with and without the one that exchanges its "
                   "solver. Simple BRDFs take as long as their values are written, and photons "
                   "seldom come to layers that are left out: both gain little.",
                   "seconds, planned", "times as long without a plan"};
    plot.joined = false;
    std::vector<Contest> contests;
    const auto add = [&](Contest contest) { contests.push_back(std::move(contest)); };
    run.step("savings");
    add(of_tables(run, "blinn_phong", "{ model = \"blinn_phong\" }", 1));
    add(of_tables(run, "ashikhmin_shirley", "{ model = \"ashikhmin_shirley\" }", 1));
    add(of_tables(run, "he_torrance", "{ model = \"he_torrance\" }", 1));
    add(of_tables(run, "two of three lobes off",
                  "{ model = \"ggx\" }, { model = \"phong\", weight = 0 }, "
                  "{ model = \"strauss\", weight = 0 }",
                  1));
    add(of_tables(run, "a lobe of no reflectance",
                  "{ model = \"oren_nayar\" }, { model = \"cook_torrance\", "
                  "parameters = { fresnel = \"dielectric\", eta = 1 } }",
                  1));
    add(of_tables(run, "grey gloss on a colour",
                  "{ model = \"lambert\", parameters = { rho = [0.5, 0.3, 0.2] } }, "
                  "{ model = \"ggx\", parameters = { fresnel = \"dielectric\" } }",
                  1));
    add(of_tables(run, "three channels that agree",
                  "{ model = \"ggx\", parameters = { fresnel = \"dielectric\", "
                  "eta = [1.5, 1.5, 1.5] } }",
                  1));
    add(of_tables(run, "one table, twice", "{ model = \"oren_nayar\" }", 2));
    add(of_layers());
    add(of_photons(run));
    add(of_skin(run));
    std::vector<std::function<double()>> runs;
    for (const Contest& contest : contests) {
        runs.push_back(contest.planned);
        runs.push_back(contest.general);
    }
    const std::vector<Quartiles> took = interleaved(runs, run.rounds());
    const auto add_point = [&](const char* series, const std::string& name, const Quartiles& a,
                               const Quartiles& b) {
        plot.points.push_back(
            {series, name, a, {b.median / a.median, b.low / a.high, b.high / a.low}});
    };
    Quartiles planned, general;
    for (std::size_t k = 0; k < contests.size(); ++k) {
        const Quartiles &a = took[2 * k], &b = took[2 * k + 1];
        add_point("scenes", contests[k].name, a, b);
        if (contests[k].name == exchanged)
            add_point("batches", "all but those totals", planned, general);
        planned = sum(planned, a);
        general = sum(general, b);
    }
    add_point("batches", "all of them", planned, general);
    return plot;
}

}  // namespace gonio
