#pragma once
// `carom study`: the plan of a study, the codes of its participants, its data.

namespace CLI {
class App;
}

namespace carom {

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addStudy(CLI::App& app, int& status);

}  // namespace carom
