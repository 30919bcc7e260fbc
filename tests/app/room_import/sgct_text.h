#pragma once
// A small room file of SGCT and its variants.

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "app/room_import/sgct_file.h"
#include "app/temporary_folder.h"

namespace carom::test::sgct {

inline Room read(const std::string& text) {
  const TemporaryFolder folder;
  return readSgct(folder.file("room.json", text));
}

inline const std::string kGood = R"({
  "version": 1, "masteraddress": "localhost",
  "nodes": [{ "address": "localhost", "port": 20400, "windows": [{
    "pos": { "x": 50, "y": 60 }, "size": { "x": 1280, "y": 720 },
    "viewports": [{
      "projection": {
        "type": "ProjectionPlane",
        "lowerleft": { "x": -1.6, "y": -0.9, "z": 0.0 },
        "upperleft": { "x": -1.6, "y": 0.9, "z": 0.0 },
        "upperright": { "x": 1.6, "y": 0.9, "z": 0.0 }
      }
    }]
  }] }],
  "users": [{ "eyeseparation": 0.06, "pos": { "x": 0, "y": 0, "z": 4.0 } }]
}
)";

inline std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// kGood with another projection.
inline std::string projected(const std::string& projection) {
  const std::size_t begin = kGood.find("\"type\""), end = kGood.find("      }\n    }]");
  std::string text = kGood;
  return text.replace(begin, end - begin, projection + " ");
}

}  // namespace carom::test::sgct
