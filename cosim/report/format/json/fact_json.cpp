#include "cosim/report/format/json/fact_json.hpp"

#include "cosim/report/format/json/command_json.hpp"
#include "cosim/text/byte_text.hpp"

namespace armature::cosim {
namespace {

struct ToJson {
  Json operator()(std::monostate) const { return nullptr; }
  template <class T>
  Json operator()(const T& value) const {
    return value;
  }
  template <class T>
  Json operator()(const OfAxes<T>& value) const {
    return value.values;
  }
  Json operator()(const Point& value) const { return vector_json(value.mm); }
  Json operator()(const Orientation& value) const { return value.rpy_deg; }
  Json operator()(const NamedDeviation& value) const {
    Json json = {{"mm", value.mm}, {"tick", value.where.tick}, {"cycle", value.where.at.value()}};
    json.update(command_json(value.move, value.command));
    return json;
  }
  Json operator()(const SerialText& value) const { return hex_of_bytes(value.bytes); }
  Json operator()(const std::vector<OutputChange>& value) const {
    Json array = Json::array();
    for (const OutputChange& change : value) {
      array.push_back({{"pin", change.pin}, {"level", change.level ? 1 : 0}, {"cycle", change.at.value()}});
      if (change.tool_mm) array.back()["tool_mm"] = vector_json(*change.tool_mm);
    }
    return array;
  }
};

}  // namespace

Json vector_json(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Json fact_json(const FactValue& value) {
  return std::visit(ToJson{}, value);
}

}  // namespace armature::cosim
