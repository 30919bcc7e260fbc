#include "app/report/report_library.h"

#include "cave/process/loaded_library.h"

namespace carom {

const ReportLibrary& reportLibrary() {
  static const auto& library = *static_cast<const ReportLibrary*>(
      loadedLibrary("libcarom_report.so", "caromReportLibrary", "draws charts and writes sculptures"));
  return library;
}

}  // namespace carom
