// The one name by which the library is known to those that load it (app/report/report_library.h).
#include "app/report/report_library.h"

extern "C" const carom::ReportLibrary caromReportLibrary{carom::svgOf, carom::pngOf, carom::exportSculpture};
