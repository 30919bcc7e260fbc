#include "app/room_formats/mpcdi_archive.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "app/toml/input_file.h"
#include "engine/text/outside_file.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

constexpr const char* kDescription = "mpcdi.xml";
constexpr std::size_t kMostFiles = 1000;

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw InputErrors({InputError(file.string(), 1, 1, what)});
}

/// Bytes in memory, as minizip reads a file.
struct Memory {
  const std::string* bytes;
  std::size_t at = 0;
};

Memory& memoryOf(voidpf stream) { return *static_cast<Memory*>(stream); }

voidpf openMemory(voidpf memory, const void*, int) { return memory; }

uLong readMemory(voidpf, voidpf stream, void* to, uLong size) {
  Memory& memory = memoryOf(stream);
  const std::size_t got =
      std::min<std::size_t>(size, memory.bytes->size() - std::min(memory.at, memory.bytes->size()));
  if (got > 0) std::memcpy(to, memory.bytes->data() + memory.at, got);
  memory.at += got;
  return static_cast<uLong>(got);
}

uLong writeMemory(voidpf, voidpf, const void*, uLong) { return 0; }

ZPOS64_T tellMemory(voidpf, voidpf stream) { return memoryOf(stream).at; }

long seekMemory(voidpf, voidpf stream, ZPOS64_T offset, int origin) {
  Memory& memory = memoryOf(stream);
  const std::size_t from = origin == ZLIB_FILEFUNC_SEEK_SET   ? 0
                           : origin == ZLIB_FILEFUNC_SEEK_CUR ? memory.at
                                                              : memory.bytes->size();
  if (offset > memory.bytes->size() || from + offset > memory.bytes->size()) return -1;
  memory.at = from + static_cast<std::size_t>(offset);
  return 0;
}

int closeMemory(voidpf, voidpf) { return 0; }
int errorOfMemory(voidpf, voidpf) { return 0; }

/// A zip archive that is open; null if it is none.
class Zip {
 public:
  explicit Zip(const std::string& bytes) : memory_{&bytes} {
    zlib_filefunc64_def io{};
    io.zopen64_file = openMemory;
    io.zread_file = readMemory;
    io.zwrite_file = writeMemory;
    io.ztell64_file = tellMemory;
    io.zseek64_file = seekMemory;
    io.zclose_file = closeMemory;
    io.zerror_file = errorOfMemory;
    io.opaque = &memory_;
    zip_ = unzOpen2_64("", &io);
  }
  Zip(const Zip&) = delete;
  Zip& operator=(const Zip&) = delete;
  ~Zip() {
    if (zip_) unzClose(zip_);
  }

  unzFile get() const { return zip_; }

  /// Returns the name of the present file and its size.
  std::pair<std::string, std::size_t> present() const {
    std::array<char, 1024> name{};
    unz_file_info64 info{};
    if (unzGetCurrentFileInfo64(zip_, &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0) != UNZ_OK)
      return {};
    return {name.data(), static_cast<std::size_t>(info.uncompressed_size)};
  }

 private:
  Memory memory_;
  unzFile zip_ = nullptr;
};

/// Returns whether a name leads out of its folder, or begins at the root.
bool leadsOut(const std::string& name) {
  if (name.find('\\') != std::string::npos || name.find(':') != std::string::npos) return true;
  const std::filesystem::path path(name);
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

MpcdiArchive::MpcdiArchive(const std::filesystem::path& file)
    : file_(file), bytes_(carom::contentOf(file, InputKind::mpcdi)), isZip_(bytes_.starts_with("PK")) {
  if (!isZip_) return;
  const Zip zip(bytes_);
  if (!zip.get() || unzGoToFirstFile(zip.get()) != UNZ_OK)
    refuse(file, "this is no zip archive, or a broken one, expected an .mpcdi");
  const std::size_t most = limitOf(InputKind::mpcdi).most_MiB << 20U;
  std::size_t all = 0;
  do {
    const auto [name, size] = zip.present();
    if (name.empty() || sizes_.size() >= kMostFiles)
      refuse(file,
             fmt::format("the archive has broken names or over {} files, expected an .mpcdi", kMostFiles));
    if (leadsOut(name))
      refuse(file, fmt::format("the archive holds '{}', which leads out of it, expected names inside",
                               printable(name)));
    all = size > most ? most + 1 : all + size;
    if (all > most)
      refuse(file, fmt::format("the archive unpacks to more than {} MiB, with '{}', expected at most that",
                               limitOf(InputKind::mpcdi).most_MiB, printable(name)));
    sizes_.emplace(name, size);
  } while (unzGoToNextFile(zip.get()) == UNZ_OK);
}

std::string MpcdiArchive::description() const {
  if (!isZip_) return bytes_;
  if (!sizes_.contains(kDescription))
    refuse(file_, fmt::format("the archive has no {}, expected one", kDescription));
  try {
    return contentOf(kDescription, limitOf(InputKind::xml).most_MiB << 20U);
  } catch (const std::runtime_error& fault) {
    refuse(file_, fault.what());
  }
}

std::string MpcdiArchive::contentOf(const std::string& name, std::size_t most) const {
  const std::string shown = printable(name);
  if (name.empty() || leadsOut(name))
    throw std::runtime_error(fmt::format("the name '{}' leads out of the {}, expected one inside", shown,
                                         isZip_ ? "archive" : "folder"));
  if (!isZip_) {
    const std::filesystem::path path = file_.parent_path() / name;
    if (std::filesystem::exists(path) && !liesBelow(path, file_.parent_path()))
      throw std::runtime_error(fmt::format("'{}' is {}", shown, outsideWords(path, file_.parent_path())));
    const std::string content = carom::contentOf(path, InputKind::mpcdi);
    if (content.size() > most)
      throw std::runtime_error(fmt::format("'{}' has over {} bytes, expected fewer", shown, most));
    return content;
  }
  const auto known = sizes_.find(name);
  if (known == sizes_.end())
    throw std::runtime_error(fmt::format("the archive has no '{}', expected it", shown));
  if (known->second > most)
    throw std::runtime_error(
        fmt::format("'{}' has {} bytes, expected at most {}", shown, known->second, most));
  const Zip zip(bytes_);
  std::string content(known->second, '\0');
  constexpr int kWithCase = 1;
  const bool isWhole = zip.get() && unzLocateFile(zip.get(), name.c_str(), kWithCase) == UNZ_OK &&
                       unzOpenCurrentFile(zip.get()) == UNZ_OK &&
                       unzReadCurrentFile(zip.get(), content.data(), static_cast<unsigned>(content.size())) ==
                           static_cast<int>(content.size()) &&
                       unzCloseCurrentFile(zip.get()) == UNZ_OK;
  if (!isWhole)
    throw std::runtime_error(fmt::format("'{}' is broken in the archive, expected it whole", shown));
  return content;
}

}  // namespace carom
