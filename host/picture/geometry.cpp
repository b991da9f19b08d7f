// SPDX-License-Identifier: Apache-2.0
// Rays by Embree.
#include "picture/geometry.hpp"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "gonio/errors.hpp"

namespace gonio {
namespace {

using glm::dvec3;

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, Release>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, Release>;
using EmbreeGeometry = std::unique_ptr<RTCGeometryTy, Release>;

/// Rounding leaves this much of a length.
constexpr double rounding = 1e-6;

template <class Element>
void put(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
         const std::vector<Element>& elements)
{
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
    if (buffer == nullptr) throw std::bad_alloc();
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(Element));
}

RTCRay ray_of(dvec3 origin, dvec3 direction, double near, double far)
{
    const glm::vec3 o(origin), d(direction);
    return {.org_x = o.x,
            .org_y = o.y,
            .org_z = o.z,
            .tnear = static_cast<float>(near),
            .dir_x = d.x,
            .dir_y = d.y,
            .dir_z = d.z,
            .time = 0,
            .tfar = static_cast<float>(far),
            .mask = ~0U,
            .id = 0,
            .flags = 0};
}

/// a at the first corner, b and c at the others.
template <class Corners>
dvec3 interpolate(const Corners& corners, const std::array<double, 3>& weights)
{
    return weights[0] * dvec3(corners[0]) + weights[1] * dvec3(corners[1]) +
           weights[2] * dvec3(corners[2]);
}

/// Hanika 2021: the point moved by the weighted mean of its distances to the planes at the corners.
dvec3 lift(dvec3 position, const std::array<dvec3, 3>& corners, const std::array<dvec3, 3>& normals,
           const std::array<double, 3>& weights)
{
    dvec3 moved = position;
    for (std::size_t c = 0; c < 3; ++c) {
        const double above = std::min(0.0, glm::dot(position - corners[c], normals[c]));
        moved -= weights[c] * above * normals[c];
    }
    return moved;
}

}  // namespace

struct Geometry::Scene {
    EmbreeDevice device;
    EmbreeScene scene;
};

Geometry::Geometry(std::vector<Mesh> meshes) : meshes_(std::move(meshes))
{
    // One thread, so that the tree is the same wherever it is built.
    scene_ = std::make_unique<Scene>();
    scene_->device.reset(rtcNewDevice("threads=1"));
    if (!scene_->device)
        throw RunError(fmt::format("Embree does not start: error {}",
                                   static_cast<int>(rtcGetDeviceError(nullptr))));
    scene_->scene.reset(rtcNewScene(scene_->device.get()));
    rtcSetSceneFlags(scene_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    float largest = 0;
    for (const Mesh& mesh : meshes_) {
        const EmbreeGeometry geometry(
            rtcNewGeometry(scene_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        put(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
        put(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene_->scene.get(), geometry.get());
        for (const glm::vec3& p : mesh.positions)
            largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    near_ = 4 * rounding * static_cast<double>(largest);
    rtcCommitScene(scene_->scene.get());
}

Geometry::~Geometry() = default;

std::optional<Hit> Geometry::hit(dvec3 origin, dvec3 direction) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit found{ray_of(origin, direction, 0, std::numeric_limits<double>::infinity()), {}};
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_->scene.get(), &context, &found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const Mesh& mesh = meshes_[found.hit.geomID];
    const auto& triangle = mesh.triangles[found.hit.primID];
    std::array<dvec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.positions[triangle[c]];
    std::array<dvec3, 3> normals = mesh.normals[found.hit.primID];
    const double u = static_cast<double>(found.hit.u), v = static_cast<double>(found.hit.v);
    const std::array weights{1 - u - v, u, v};

    // The flat triangle has two sides, and the ray is on one of them.
    dvec3 flat = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    if (glm::dot(flat, direction) > 0) flat = -flat;
    const double side = glm::dot(interpolate(normals, weights), flat);
    for (dvec3& normal : normals) normal = side == 0 ? flat : side < 0 ? -normal : normal;
    const dvec3 position = interpolate(corners, weights);
    return Hit{found.hit.geomID, position, lift(position, corners, normals, weights),
               glm::normalize(interpolate(normals, weights))};
}

bool Geometry::hides(const Hit& hit, dvec3 direction, double distance) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = ray_of(hit.lifted, direction, near_, distance - near_);
    rtcOccluded1(scene_->scene.get(), &context, &ray);
    return ray.tfar < 0;
}

}  // namespace gonio
