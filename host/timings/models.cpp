// SPDX-License-Identifier: Apache-2.0
// Every model of the registry on a dense grid, at several widths.
#include <fmt/format.h>

#include <set>

#include "opencl/grid_kernel.hpp"
#include "opencl/store_rate.hpp"
#include "timings/sections.hpp"
#include "verify/verify.hpp"

namespace gonio {
namespace {

constexpr std::size_t thetas = 64, azimuths = 1024, cells = thetas * thetas * azimuths;

/// A model's kernel, ready to run over the whole grid.
struct Evaluation {
    Device device;
    DirectionTables tables;
    GridKernel kernel;
    OutputBuffer out;

    Evaluation(const Device& on, const Model& model)
        : device(on),
          tables(direction_tables(isotropic_grid(thetas, thetas, azimuths, Samples::centre, 180),
                                  false)),
          kernel(device.state(), {std::string(model.id), {default_lobe(model.id)}}, tables,
                 {"", Measure::brdf, false, false, device.width()}),
          out(device.state(), cells)
    {
        seconds();  // touches the pages
    }

    double seconds()
    {
        const auto event = kernel.enqueue(out, 0, tables.rows);
        event.wait();
        return seconds_of(event);
    }
};

void measure_model(const BenchRun& run, const Device& device, const Model& model, double error,
                   BenchPlot& plot)
{
    Evaluation evaluation(device, model);
    StoreRate store(run.device.state());
    const std::vector<Quartiles> seconds = interleaved(
        {[&] { return evaluation.seconds(); }, [&] { return store.seconds(); }}, run.rounds());
    const auto nanoseconds = [](double all) { return all * 1e9 / double(cells); };
    const Quartiles& own = seconds[0];
    const double roof = seconds[1].median * double(cells) / StoreRate::count;
    plot.points.push_back(
        {fmt::format("width {}", device.width()),
         std::string(model.id),
         {nanoseconds(own.median), nanoseconds(own.low), nanoseconds(own.high)},
         exactly(error),
         false,
         {{"Geval_per_s", 1 / nanoseconds(own.median)}, {"of_store", roof / own.median}}});
}

}  // namespace

BenchPlot bench_models(const BenchRun& run)
{
    BenchPlot plot{"models", "Every model on a dense grid",
                   "An isotropic grid with the azimuth innermost, without symmetry, by the "
                   "device's clock. The error "
                   "is the largest relative one against the reference in double precision (gonio "
                   "verify --quick); it "
                   "is the same at every width, as the bits are. Kernels have one precision, "
                   "float32: OpenCL 1.2 promises no other, double is optional there. What half "
                   "loses in a table is in the plots of tables.",
                   "ns per evaluation", "largest relative error"};
    plot.joined = false;
    std::set<unsigned> widths{run.device.width()};
    if (!run.quick) widths.merge(std::set<unsigned>{1, 4, 8, 16});
    std::vector<Device> devices;
    for (const unsigned width : widths) devices.push_back(run.at_width(width));
    for (const Model& model : models()) {
        run.step(fmt::format("models: {}", model.id));
        const double error = verify_model(run.device, model, true).accuracy.relative;
        for (const Device& device : devices) measure_model(run, device, model, error, plot);
    }
    return plot;
}

}  // namespace gonio
