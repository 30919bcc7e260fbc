#pragma once
// `carom link`: keys of linked rooms, and the line between them.

namespace CLI {
class App;
}

namespace carom {

/// Adds the command to `app`. When it runs, it stores its exit status in `status`.
void addLinkTools(CLI::App& app, int& status);

}  // namespace carom
