#include "cave/pictures/picture_files.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFReader.h>
#include <vtkUnsignedCharArray.h>

namespace carom {
namespace {

constexpr int kWidest_px = 16384;

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

}  // namespace

std::string pngOf(const glm::ivec2& size_px, std::span<const std::uint8_t> rgb) {
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(size_px.x, size_px.y, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(rgb.begin(), rgb.end(), static_cast<std::uint8_t*>(pixels->GetScalarPointer()));

  vtkNew<vtkPNGWriter> encoder;
  encoder->SetInputData(pixels);
  encoder->SetCompressionLevel(3);
  encoder->WriteToMemoryOn();
  encoder->Write();
  vtkUnsignedCharArray* png = encoder->GetResult();
  return {reinterpret_cast<const char*>(png->GetPointer(0)),
          static_cast<std::size_t>(png->GetNumberOfValues())};
}

std::string pixelBytes(const std::filesystem::path& file) {
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
  if (size_px.x < 1 || size_px.y < 1 || size_px.x > kWidest_px || size_px.y > kWidest_px) {
    throw std::runtime_error(
        fmt::format("has {} × {} pixels, expected 1 to {} each way", size_px.x, size_px.y, kWidest_px));
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

}  // namespace carom
