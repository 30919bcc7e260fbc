#include "cave/projection/projector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/pictures/picture_library.h"
#include "cave/process/subprocess.h"
#include "cave/warps/warp_file.h"
#include "engine/text/outside_file.h"
#include "shaders/projector_frag.h"
#include "shaders/projector_vert.h"

namespace carom {
namespace {

/// Returns the code of linear light for a projector: sRGB (IEC 61966-2-1), or that of its gamma.
float codeOf(double light, const std::optional<glm::dvec3>& gamma, int colour) {
  if (gamma) return static_cast<float>(std::pow(light, 1.0 / (*gamma)[colour]));
  return static_cast<float>(light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}

/// Sets the state for drawing into a picture; afterwards no framebuffer is bound.
class DrawInto {
 public:
  explicit DrawInto(const RenderTarget& picture) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, picture.framebuffer());
    glViewport(0, 0, picture.size_px().x, picture.size_px().y);
    for (const GLenum test : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) glDisable(test);
  }
  ~DrawInto() { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0); }
  DrawInto(const DrawInto&) = delete;
  DrawInto& operator=(const DrawInto&) = delete;
};

BlendPicture blendFrom(const std::string& bytes) {
  BlendPicture blend;
  std::memcpy(&blend.size_px, bytes.data(), sizeof(blend.size_px));
  blend.rgb.resize((bytes.size() - sizeof(blend.size_px)) / 2);
  std::memcpy(blend.rgb.data(), bytes.data() + sizeof(blend.size_px), 2 * blend.rgb.size());
  return blend;
}

BlendPicture blendOf(VwfFile file) {
  if (file.blend.empty()) throw std::runtime_error("has no blend, expected one");
  return {file.blend_px, std::move(file.blend)};
}

}  // namespace

BlendPicture readBlend(const std::filesystem::path& file) {
  const bool isPicture = file.extension() != ".vwf";
  if (isPicture) pictureLibrary();  // before the process that reads begins
  try {
    if (!isPicture) return blendOf(parseVwf(contentOf(file, InputKind::screenGrid)));
    if (const std::string refusal = refusalOf(file, InputKind::blend); !refusal.empty())
      throw std::runtime_error(refusal);
    return blendFrom(runInSubprocess([&] { return pictureLibrary().pixelBytes(file); }));
  } catch (const JobTooLarge& lost) {
    throw JobTooLarge(file.string() + ":1:1: " + lost.what() + ", expected a smaller picture");
  } catch (const SubprocessFailed&) {
    throw std::runtime_error(file.string() + ":1:1: is broken, expected the picture whole");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ":1:1: " + error.what());
  }
}

std::optional<Projection> projectionOf(const Wall& wall) {
  const bool coloured = wall.gain != glm::dvec3(1.0) || wall.gamma || !wall.colourWarps[0].empty();
  if (!wall.skewed && wall.warp.empty() && wall.blend.empty() && wall.blackLevel == 0.0 &&
      wall.flip == Flip::none && !coloured)
    return {};
  Projection projection{.warp = wall.skewed         ? skewWarp(*wall.skewed)
                                : wall.warp.empty() ? straightWarp()
                                                    : readWarp(wall.warp, wall.pixels),
                        .blend = wall.blend.empty() ? BlendPicture{} : readBlend(wall.blend),
                        .blackLevel = wall.blackLevel,
                        .flip = wall.flip,
                        .gain = wall.gain,
                        .gamma = wall.gamma};
  if (!wall.colourWarps[0].empty()) {
    projection.colourWarps = {readWarp(wall.colourWarps[0], wall.pixels),
                              readWarp(wall.colourWarps[1], wall.pixels),
                              readWarp(wall.colourWarps[2], wall.pixels)};
  }
  return projection;
}

Projector::Projector(const Projection& projection)
    : program_(makeProgram("projector", shaders::projector_vert, shaders::projector_frag)),
      dark_{codeOf(projection.blackLevel, projection.gamma, 0),
            codeOf(projection.blackLevel, projection.gamma, 1),
            codeOf(projection.blackLevel, projection.gamma, 2)} {
  if (projection.colourWarps) {
    addMeshes({true, false, false}, (*projection.colourWarps)[0]);
    addMeshes({false, true, false}, (*projection.colourWarps)[1]);
    addMeshes({false, false, true}, (*projection.colourWarps)[2]);
  } else {
    addMeshes({true, true, true}, projection.warp);
  }
  uploadBlend(projection.blend);
  const glm::vec3 gain(projection.gain);
  const glm::vec3 gamma(projection.gamma.value_or(glm::dvec3(0.0)));
  const bool across = projection.flip == Flip::horizontal || projection.flip == Flip::both;
  const bool up = projection.flip == Flip::vertical || projection.flip == Flip::both;
  glUseProgram(program_);
  glUniform1i(glGetUniformLocation(program_, "picture"), 0);
  glUniform1i(glGetUniformLocation(program_, "blend"), 1);
  glUniform1f(glGetUniformLocation(program_, "black"), static_cast<float>(projection.blackLevel));
  glUniform3f(glGetUniformLocation(program_, "gain"), gain.x, gain.y, gain.z);
  glUniform3f(glGetUniformLocation(program_, "gamma"), gamma.x, gamma.y, gamma.z);
  glUniform2f(glGetUniformLocation(program_, "mirror"), across ? -1.0F : 1.0F, up ? -1.0F : 1.0F);
}

void Projector::addMeshes(const std::array<bool, 3>& colours, const Warp& warp) {
  meshes_.push_back({colours, {DrawnMesh(program_, warp.left), DrawnMesh(program_, warp.right)}});
}

Projector::DrawnMesh::DrawnMesh(const GlProgram& program, const WarpMesh& mesh)
    : points(program, {{"inWindow", 2, offsetof(WarpPoint, inWindow)},
                       {"inPicture", 2, offsetof(WarpPoint, inPicture)},
                       {"weight", 1, offsetof(WarpPoint, weight)},
                       {"light", 1, offsetof(WarpPoint, light)}}),
      corners(static_cast<int>(3 * mesh.triangles.size())) {
  points.upload(mesh.points);
  points.bind();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
               mesh.triangles.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void Projector::uploadBlend(const BlendPicture& blend) {
  glBindTexture(GL_TEXTURE_2D, blend_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16, blend.size_px.x, blend.size_px.y, 0, GL_RGB, GL_UNSIGNED_SHORT,
               blend.rgb.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

const RenderTarget& Projector::project(const RenderTarget& picture, Eye eye, const glm::ivec2& size_px) {
  const std::size_t which = eye == Eye::right ? 1 : 0;
  std::unique_ptr<RenderTarget>& projected = projected_[which];
  if (!projected || projected->size_px() != size_px) projected = std::make_unique<RenderTarget>(size_px);
  const DrawInto target(*projected);
  const std::array<float, 4> outside{dark_[0], dark_[1], dark_[2], 1.0F};
  glClearBufferfv(GL_COLOR, 0, outside.data());
  glUseProgram(program_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, blend_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture.texture());
  for (const ColourMeshes& part : meshes_) {
    glColorMask(part.colours[0], part.colours[1], part.colours[2], GL_TRUE);
    part.meshes[which].points.bind();
    glDrawElements(GL_TRIANGLES, part.meshes[which].corners, GL_UNSIGNED_INT, nullptr);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBindVertexArray(0);
  return *projected;
}

}  // namespace carom
