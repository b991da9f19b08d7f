// SPDX-License-Identifier: Apache-2.0
// Where an integral over the hemisphere has its nodes.
#include "quadrature/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grid/angles.hpp"
#include "quadrature/rules.hpp"

namespace gonio {
namespace {

using std::numbers::pi;

/// An azimuth in degrees where the integrand is singular at a distance `depth` in the complex
/// plane; large if it is smooth and a panel merely ends there.
struct Feature {
    double azimuth, depth;
};

constexpr double smooth = 1e3;

/// Lines of nodes for one direction.
class Nodes {
public:
    Nodes(quadrature_map map, const Incidence& at, const Spread& spread,
          const Smoothness& smoothness, int order)
        : map_(map),
          cosine_(at.cosine),
          sine_(std::sqrt((1 - at.cosine) * (1 + at.cosine))),
          phi_(at.phi),
          spread_(spread),
          smoothness_(smoothness),
          rule_(rule_of(std::max(4, order / 2)))
    {
    }

    std::vector<AzimuthNode> all()
    {
        const auto features = smoothness_.isotropic ? half_circle() : circle();
        for (std::size_t k = 0; k + 1 < features.size(); ++k) {
            const double middle = (features[k].azimuth + features[k + 1].azimuth) / 2;
            const bool whole = features[k].depth >= smooth && features[k + 1].depth >= smooth;
            if (whole || features[k + 1].depth >= smooth) {
                panel(features[k], features[k + 1].azimuth);
            } else if (features[k].depth >= smooth) {
                panel(features[k + 1], features[k].azimuth);
            } else {
                panel(features[k], middle);
                panel(features[k + 1], middle);
            }
        }
        return std::move(nodes_);
    }

private:
    /// Of half vectors, at grazing light, across the plane of incidence.
    double grazing_depth() const { return sine_ > 0 ? cosine_ / sine_ : smooth; }

    /// From 0 to 180 degrees, where masking and cosines that change hands do so at the horizon,
    /// too.
    std::vector<Feature> half_circle() const
    {
        std::vector<Feature> features{{0, smooth}, {90, grazing_depth()}, {180, smooth}};
        if (smoothness_.kinks && map_ == map_half)
            for (const double tangent : {1.0, 1 / std::sqrt(3.0)})
                if (tangent * cosine_ < sine_)
                    features.push_back({std::acos(tangent * cosine_ / sine_) * 180 / pi, smooth});
        std::ranges::sort(features, {}, &Feature::azimuth);
        return features;
    }

    /// Once around, relative to the plane of incidence: across it, and along the ridge.
    std::vector<Feature> circle() const
    {
        const double ratio = std::min(spread_.x, spread_.y) / std::max(spread_.x, spread_.y);
        const double ridge = (spread_.x < spread_.y ? 90 : 0) - phi_;
        std::vector<Feature> features;
        const auto add = [&](double azimuth, double depth) {
            const auto near = std::ranges::find_if(features, [&](const Feature& other) {
                return std::abs(std::remainder(other.azimuth - azimuth, 360)) < 1e-9;
            });
            const double turned = std::remainder(azimuth, 360);
            if (near == features.end())
                features.push_back({turned < 0 ? turned + 360 : turned, depth});
            else
                near->depth = std::min(near->depth, depth);
        };
        for (const double side : {0, 180}) {
            add(side + 90, grazing_depth());
            add(side + ridge, map_ == map_hemisphere ? smooth : ratio);
            add(side, smooth);
        }
        std::ranges::sort(features, {}, &Feature::azimuth);
        features.push_back({features.front().azimuth + 360, features.front().depth});
        return features;
    }

    /// Azimuths from a feature to `end`, crowding at the feature (Tee & Trefethen, SIAM J. Sci.
    /// Comput. 28(5), 2006: sinh makes a singularity at that depth harmless).
    void panel(const Feature& feature, double end)
    {
        const double length = std::abs(end - feature.azimuth) * pi / 180;
        if (length < 1e-12) return;
        const double sign = end > feature.azimuth ? 1 : -1;
        const bool crowd = feature.depth < 1;
        const double depth = std::max(feature.depth, 1e-12);
        const double span = crowd ? std::asinh(length / depth) : length;
        const double both_halves = smoothness_.isotropic ? 2 : 1;
        for (Eigen::Index k = 0; k < rule_.nodes.size(); ++k) {
            const double w = span * rule_.nodes[k];
            const double away = sign * (crowd ? depth * std::sinh(w) : w);
            const double rate = span * (crowd ? depth * std::cosh(w) : 1);
            line(feature.azimuth, away, both_halves * rate * rule_.weights[k]);
        }
    }

    void line(double feature, double away, double weight)
    {
        AzimuthNode node{};
        // The feature's own sine and cosine are exact where they are 0.
        const auto turned = [away](double degrees, double& cosine, double& sine) {
            const double c = cosine_of_degrees(degrees), s = sine_of_degrees(degrees);
            cosine = c * std::cos(away) - s * std::sin(away);
            sine = s * std::cos(away) + c * std::sin(away);
        };
        turned(feature, node.cosine, node.sine);
        turned(feature + phi_, node.frame_cosine, node.frame_sine);
        node.weight = weight;
        if (map_ == map_hemisphere) return hemisphere_line(node);
        const double slope = sine_ * node.cosine / cosine_;
        const double root = std::sqrt(slope * slope + 1);
        node.end = slope < 0 ? 1 / (root - slope) : root + slope;
        node.scale = 1 / std::hypot(node.frame_cosine / spread_.x, node.frame_sine / spread_.y);
        double from = 0;
        for (const double tangent : breaks(slope, node.end)) {
            const double to = std::asinh(tangent / node.scale);
            add(node, from, to);
            from = to;
        }
    }

    /// The variable is sqrt(1 - tan(theta/2)): soft at the horizon, with a panel's end at theta_i,
    /// where cosines change hands.
    void hemisphere_line(AzimuthNode& node)
    {
        node.end = 1;
        node.scale = 1;
        const double middle = std::sqrt(std::max(0.0, 1 - sine_ / (1 + cosine_)));
        add(node, 0, middle);
        add(node, middle, 1);
    }

    void add(AzimuthNode& node, double from, double to)
    {
        if (!(to > from)) return;
        node.from = from;
        node.span = to - from;
        nodes_.push_back(node);
    }

    /// Where radial panels end, in tangents, for half vectors at an azimuth with tan theta_i
    /// cos(azimuth) = slope: where grooves begin to mask l, then v, and where the two exchange; at
    /// right angles to the mirror direction, where cosine lobes end.
    std::vector<double> breaks(double slope, double end) const
    {
        std::vector<double> tangents;
        if (map_ == map_mirror) tangents = {1};
        if (map_ == map_half && smoothness_.kinks) {
            tangents = {slope, 1 / slope};
            const double third = std::atan2(1, -slope) / 3;
            for (const double angle : {third, third + pi / 3}) tangents.push_back(std::tan(angle));
        }
        std::erase_if(tangents, [end](double t) { return !(t > 0 && t < end); });
        tangents.push_back(end);
        std::ranges::sort(tangents);
        return tangents;
    }

    quadrature_map map_;
    double cosine_, sine_, phi_;
    Spread spread_;
    Smoothness smoothness_;
    const reference::QuadratureRule& rule_;
    std::vector<AzimuthNode> nodes_;
};

}  // namespace

std::vector<AzimuthNode> azimuth_nodes(quadrature_map map, const Incidence& at,
                                       const Spread& spread, const Smoothness& smoothness,
                                       int order)
{
    return Nodes(map, at, spread, smoothness, order).all();
}

}  // namespace gonio
