#include "app/room_formats/sgct_xml.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

namespace carom {
namespace {

using Kind = JsonNode::Kind;

std::string lowered(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return low;
}

/// The names of SGCT 1 and 2 that SGCT 3 calls otherwise.
std::string newName(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 13> kNames{{{"ip", "address"},
                                                                    {"numberofsamples", "msaa"},
                                                                    {"mask", "blendmask"},
                                                                    {"correctionmesh", "mesh"},
                                                                    {"heading", "yaw"},
                                                                    {"azimuth", "yaw"},
                                                                    {"elevation", "pitch"},
                                                                    {"bank", "roll"},
                                                                    {"decorated", "border"},
                                                                    {"vrpnaddress", "vrpnaddress"},
                                                                    {"id", "identifier"},
                                                                    {"dataTransferPort", "datatransferport"},
                                                                    {"resolution", "res"}}};
  const std::string low = lowered(name);
  for (const auto& [old, now] : kNames) {
    if (low == lowered(old)) return std::string(now);
  }
  return low;
}

JsonNode objectAt(const Part& part, std::string key) {
  return {.kind = Kind::object, .at = part.at, .key = std::move(key), .keyAt = part.at};
}

JsonNode arrayAt(const Part& part, std::string key) {
  return {.kind = Kind::array, .at = part.at, .key = std::move(key), .keyAt = part.at};
}

/// Returns an attribute as the kind of value that its text is.
JsonNode valueOf(const Part& attribute, std::string key) {
  JsonNode node{.kind = Kind::text, .at = attribute.textAt, .key = std::move(key), .keyAt = attribute.at};
  node.text = attribute.text;
  if (const auto number = wholeNumber(attribute.text)) {
    node.kind = *number == std::floor(*number) ? Kind::whole : Kind::number;
    node.number = *number;
  } else if (alike(attribute.text, "true") || alike(attribute.text, "false")) {
    node.kind = Kind::flag;
    node.flag = alike(attribute.text, "true");
  }
  return node;
}

bool isElement(const Part& part, std::string_view name) { return alike(part.name, name); }

/// Returns an element's attributes and elements under their new names: {x, y}, {yaw, pitch, roll}.
JsonNode plainOf(const Part& element, std::string key) {
  JsonNode node = objectAt(element, std::move(key));
  for (const Part& part : element.parts)
    node.children.push_back(part.parts.empty() ? valueOf(part, newName(part.name))
                                               : plainOf(part, newName(part.name)));
  return node;
}

JsonNode textAt(const Part& part, std::string key, std::string text) {
  JsonNode node{.kind = Kind::text, .at = part.at, .key = std::move(key), .keyAt = part.at};
  node.text = std::move(text);
  return node;
}

/// Returns a plane of three Pos elements: lower left, upper left, upper right.
JsonNode planeOf(const Part& element) {
  constexpr std::array<const char*, 3> kCorners{"lowerleft", "upperleft", "upperright"};
  JsonNode plane = objectAt(element, "projection");
  plane.children.push_back(textAt(element, "type", "ProjectionPlane"));
  std::size_t corner = 0;
  for (const Part& part : element.parts) {
    const bool isCorner = isElement(part, "Pos") && corner < kCorners.size();
    if (isCorner) {
      plane.children.push_back(plainOf(part, kCorners[corner++]));
    } else {
      plane.children.push_back(valueOf(part, newName(part.name)));
    }
  }
  return plane;
}

JsonNode projectionOf(const Part& element) {
  JsonNode projection = plainOf(element, "projection");
  std::string type = element.name;
  for (const char* known : {"PlanarProjection", "FisheyeProjection", "EquirectangularProjection",
                            "CylindricalProjection", "SphericalMirrorProjection"}) {
    if (isElement(element, known)) type = known;
  }
  projection.children.insert(projection.children.begin(), textAt(element, "type", std::move(type)));
  return projection;
}

JsonNode viewportOf(const Part& element) {
  JsonNode viewport = objectAt(element, "");
  for (const Part& part : element.parts) {
    if (isElement(part, "Viewplane") || isElement(part, "Projectionplane")) {
      viewport.children.push_back(planeOf(part));
    } else if (lowered(part.name).ends_with("projection")) {
      viewport.children.push_back(projectionOf(part));
    } else if (part.parts.empty()) {
      JsonNode value = valueOf(part, newName(part.name));
      if (value.key == "identifier" || value.key == "name") continue;
      if (value.key == "eye") value.text = lowered(value.text);
      viewport.children.push_back(std::move(value));
    } else {
      viewport.children.push_back(plainOf(part, newName(part.name)));
    }
  }
  return viewport;
}

JsonNode windowOf(const Part& element) {
  JsonNode window = objectAt(element, "");
  JsonNode viewports = arrayAt(element, "viewports");
  for (const Part& part : element.parts) {
    if (isElement(part, "Viewport")) {
      viewports.children.push_back(viewportOf(part));
    } else if (isElement(part, "Stereo")) {
      for (const Part& type : part.parts) {
        JsonNode stereo = valueOf(type, "stereo");
        stereo.text = lowered(stereo.text);
        window.children.push_back(std::move(stereo));
      }
    } else if (part.parts.empty()) {
      JsonNode value = valueOf(part, newName(part.name));
      if (value.key == "identifier") value.key = "id";
      window.children.push_back(std::move(value));
    } else {
      window.children.push_back(plainOf(part, newName(part.name)));
    }
  }
  window.children.push_back(std::move(viewports));
  return window;
}

/// Returns a node; SGCT 1 has viewports beside the one window to which they belong.
JsonNode nodeOf(const Part& element) {
  JsonNode node = objectAt(element, "");
  JsonNode windows = arrayAt(element, "windows");
  std::vector<JsonNode> beside;
  for (const Part& part : element.parts) {
    if (isElement(part, "Window")) {
      windows.children.push_back(windowOf(part));
    } else if (isElement(part, "Viewport")) {
      beside.push_back(viewportOf(part));
    } else {
      node.children.push_back(valueOf(part, newName(part.name)));
    }
  }
  if (!windows.children.empty()) {
    auto& viewports = windows.children.front().children.back().children;
    viewports.insert(viewports.end(), beside.begin(), beside.end());
  }
  node.children.push_back(std::move(windows));
  return node;
}

JsonNode trackerOf(const Part& element) {
  JsonNode tracker = objectAt(element, "");
  JsonNode devices = arrayAt(element, "devices");
  for (const Part& part : element.parts) {
    if (!isElement(part, "Device")) {
      tracker.children.push_back(part.parts.empty() ? valueOf(part, newName(part.name))
                                                    : plainOf(part, newName(part.name)));
      continue;
    }
    JsonNode device = objectAt(part, "");
    JsonNode sensors = arrayAt(part, "sensors");
    for (const Part& inner : part.parts) {
      if (isElement(inner, "Sensor")) {
        sensors.children.push_back(plainOf(inner, ""));
      } else {
        device.children.push_back(inner.parts.empty() ? valueOf(inner, newName(inner.name))
                                                      : plainOf(inner, newName(inner.name)));
      }
    }
    device.children.push_back(std::move(sensors));
    devices.children.push_back(std::move(device));
  }
  tracker.children.push_back(std::move(devices));
  return tracker;
}

}  // namespace

JsonNode sgctFromXml(const Part& root) {
  JsonNode cluster = objectAt(root, "");
  JsonNode nodes = arrayAt(root, "nodes"), users = arrayAt(root, "users"),
           trackers = arrayAt(root, "trackers");
  for (const Part& part : root.parts) {
    if (isElement(part, "Node")) {
      nodes.children.push_back(nodeOf(part));
    } else if (isElement(part, "User")) {
      users.children.push_back(plainOf(part, ""));
    } else if (isElement(part, "Tracker")) {
      trackers.children.push_back(trackerOf(part));
    } else if (part.parts.empty()) {
      JsonNode value = valueOf(part, newName(part.name));
      if (value.key != "externalcontrolport") cluster.children.push_back(std::move(value));
    } else {
      cluster.children.push_back(plainOf(part, newName(part.name)));
    }
  }
  for (JsonNode* list : {&nodes, &users, &trackers}) {
    if (!list->children.empty()) cluster.children.push_back(std::move(*list));
  }
  return cluster;
}

}  // namespace carom
