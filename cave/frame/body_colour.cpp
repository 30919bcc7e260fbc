#include "cave/frame/body_colour.h"

#include <array>
#include <map>

namespace carom {

glm::vec3 colourOf(const std::string& name, std::size_t index) {
  static const std::map<std::string, glm::vec3> kNamed{
      {"white", {0.64F, 0.62F, 0.57F}},  {"yellow", {0.85F, 0.52F, 0.03F}}, {"red", {0.62F, 0.030F, 0.025F}},
      {"blue", {0.035F, 0.13F, 0.60F}},  {"green", {0.05F, 0.42F, 0.10F}},  {"orange", {0.80F, 0.22F, 0.02F}},
      {"violet", {0.30F, 0.06F, 0.50F}}, {"black", {0.035F, 0.035F, 0.04F}}};
  static const std::array<glm::vec3, 6> kPalette{{{0.05F, 0.45F, 0.55F},
                                                  {0.80F, 0.22F, 0.02F},
                                                  {0.30F, 0.06F, 0.50F},
                                                  {0.55F, 0.62F, 0.05F},
                                                  {0.75F, 0.12F, 0.32F},
                                                  {0.035F, 0.13F, 0.60F}}};
  const auto named = kNamed.find(name);
  return named != kNamed.end() ? named->second : kPalette[index % kPalette.size()];
}

}  // namespace carom
