#include "cave/projection/projector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFReader.h>
#include <vtk_glew.h>

#include "cave/gl/gl_program.h"
#include "cave/mesh_files/vwf_file.h"
#include "cave/mesh_files/warp_file.h"
#include "cave/process/subprocess.h"
#include "engine/base/outside_file.h"
#include "shaders/projector_frag.h"
#include "shaders/projector_vert.h"

namespace carom {
namespace {

constexpr int kWidestBlend_px = 16384;

/// Records that VTK reported an error.
class Complaint : public vtkCommand {
 public:
  static Complaint* New() { return new Complaint; }
  void Execute(vtkObject*, unsigned long, void*) override { heard = true; }
  bool heard = false;
};

vtkSmartPointer<vtkImageReader2> readerFor(const std::string& ending) {
  if (ending == ".png") return vtkSmartPointer<vtkPNGReader>::New();
  if (ending == ".jpg" || ending == ".jpeg") return vtkSmartPointer<vtkJPEGReader>::New();
  if (ending == ".tif" || ending == ".tiff") return vtkSmartPointer<vtkTIFFReader>::New();
  return nullptr;
}

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

/// Returns the picture as bytes: width, height, then RGB.
std::string bytesOf(const glm::ivec2& size_px, vtkDataArray& values) {
  const bool deep = values.GetDataType() == VTK_UNSIGNED_SHORT;
  const int parts = values.GetNumberOfComponents();
  std::vector<std::uint16_t> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(values.GetNumberOfTuples()));
  for (vtkIdType pixel = 0; pixel < values.GetNumberOfTuples(); ++pixel) {
    for (int part = 0; part < 3; ++part) {
      const double value = values.GetComponent(pixel, parts < 3 ? 0 : part);
      rgb.push_back(static_cast<std::uint16_t>(deep ? value : value * 257.0));  // 255 × 257 = 65535
    }
  }
  std::string bytes(reinterpret_cast<const char*>(&size_px), sizeof(size_px));
  return bytes.append(reinterpret_cast<const char*>(rgb.data()), 2 * rgb.size());
}

BlendPicture blendFrom(const std::string& bytes) {
  BlendPicture blend;
  std::memcpy(&blend.size_px, bytes.data(), sizeof(blend.size_px));
  blend.rgb.resize((bytes.size() - sizeof(blend.size_px)) / 2);
  std::memcpy(blend.rgb.data(), bytes.data() + sizeof(blend.size_px), 2 * blend.rgb.size());
  return blend;
}

/// Reads the blend picture. Run it in a subprocess: VTK's readers crash on some broken files.
std::string blendBytes(const std::filesystem::path& file) {
  std::freopen("/dev/null", "w", stderr);  // the libraries print their own messages there
  const std::string name = file.string();
  const auto reader = readerFor(file.extension().string());
  if (!reader) throw std::runtime_error("is of a kind that cannot be read, expected a PNG, JPEG or TIFF");
  if (reader->CanReadFile(name.c_str()) == 0) {
    throw std::runtime_error("is no such picture, expected one that can be read");
  }
  vtkNew<Complaint> complaint;
  for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent}) {
    reader->AddObserver(event, complaint);
  }
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  const int* extent = reader->GetDataExtent();
  const glm::ivec2 size_px(extent[1] - extent[0] + 1, extent[3] - extent[2] + 1);
  if (size_px.x < 1 || size_px.y < 1 || size_px.x > kWidestBlend_px || size_px.y > kWidestBlend_px) {
    throw std::runtime_error(
        fmt::format("has {} × {} pixels, expected 1 to {} each way", size_px.x, size_px.y, kWidestBlend_px));
  }
  reader->Update();
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  const auto pixels = static_cast<vtkIdType>(size_px.x) * size_px.y;
  if (complaint->heard || reader->GetErrorCode() != 0 || !values || values->GetNumberOfTuples() != pixels) {
    throw std::runtime_error("is broken, expected the picture whole");
  }
  if (values->GetDataType() != VTK_UNSIGNED_CHAR && values->GetDataType() != VTK_UNSIGNED_SHORT) {
    throw std::runtime_error("has numbers of another kind, expected 8 or 16 bits a colour");
  }
  return bytesOf(size_px, *values);
}

BlendPicture blendOf(VwfFile file) {
  if (file.blend.empty()) throw std::runtime_error("has no blend, expected one");
  return {file.blend_px, std::move(file.blend)};
}

}  // namespace

BlendPicture readBlend(const std::filesystem::path& file) {
  try {
    if (file.extension() == ".vwf") return blendOf(parseVwf(contentOf(file, InputKind::screenGrid)));
    if (const std::string refusal = refusalOf(file, InputKind::blend); !refusal.empty())
      throw std::runtime_error(refusal);
    return blendFrom(runInSubprocess([&] { return blendBytes(file); }));
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
