// SPDX-License-Identifier: Apache-2.0
// A header as JSON and back.
#include "output/table_json.hpp"

#include <fmt/format.h>

#include "gonio/errors.hpp"
#include "output/check.hpp"

namespace gonio {
namespace {

using Json = nlohmann::ordered_json;

Samples samples_from(const std::string& word)
{
    if (word == "centre") return Samples::centre;
    if (word == "node") return Samples::node;
    throw UsageError(fmt::format("samples are 'centre' or 'node', not '{}'", word));
}

bool single_precision_from(const std::string& word)
{
    if (word == "float32") return true;
    if (word == "float64") return false;
    throw UsageError(fmt::format("precision is 'float32' or 'float64', not '{}'", word));
}

Axis axis_from(const Json& json)
{
    Axis axis;
    json.at("name").get_to(axis.name);
    json.at("unit").get_to(axis.unit);
    axis.samples = samples_from(json.at("samples"));
    json.at("values").get_to(axis.values);
    return axis;
}

Attribute attribute_from(const Json& json)
{
    if (json.is_string()) return json.get<std::string>();
    if (json.is_array()) return json.get<std::vector<double>>();
    return json.get<double>();
}

TableHeader checked_header_from(const Json& json)
{
    TableHeader header;
    json.at("quantity").get_to(header.quantity);
    json.at("unit").get_to(header.unit);
    header.single_precision = single_precision_from(json.at("precision"));
    json.at("sweep_axes").get_to(header.sweep_axes);
    for (const auto& axis : json.at("axes")) header.axes.push_back(axis_from(axis));
    json.at("channels").get_to(header.channels);
    for (const auto& [name, value] : json.at("attributes").items()) {
        header.attributes.emplace_back(name, attribute_from(value));
    }
    check(header);
    return header;
}

}  // namespace

Json to_json(const Axis& axis)
{
    return {{"name", axis.name},
            {"unit", axis.unit},
            {"samples", axis.samples == Samples::centre ? "centre" : "node"},
            {"values", axis.values}};
}

Json to_json(const Attribute& attribute)
{
    return std::visit([](const auto& value) { return Json(value); }, attribute);
}

Json to_json(const TableHeader& header)
{
    Json axes = Json::array();
    for (const auto& axis : header.axes) axes.push_back(to_json(axis));
    Json attributes = Json::object();
    for (const auto& [name, attribute] : header.attributes) attributes[name] = to_json(attribute);
    return {{"quantity", header.quantity},
            {"unit", header.unit},
            {"precision", header.single_precision ? "float32" : "float64"},
            {"sweep_axes", header.sweep_axes},
            {"axes", axes},
            {"channels", header.channels},
            {"attributes", attributes}};
}

TableHeader header_from_json(const Json& json, const std::string& where)
{
    try {
        return checked_header_from(json);
    } catch (const Json::exception& fault) {
        throw RunError(fmt::format("{}: not the header of a table: {}", where, fault.what()));
    } catch (const UsageError& fault) {
        throw RunError(fmt::format("{}: not the header of a table: {}", where, fault.what()));
    }
}

std::string text_of(const Json& json, int indent)
{
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json parse_json(const std::string& text, const std::string& where)
{
    try {
        return Json::parse(text);
    } catch (const Json::exception& fault) {
        throw RunError(fmt::format("{}: {}", where, fault.what()));
    }
}

}  // namespace gonio
