#pragma once
// Libraries of the program that are loaded when what they do is wanted.

#include <string>

namespace carom {

/// Loads a library of this name from ../lib/carom, seen from the program's own folder, and returns the object
/// that it offers by the name `offers`. It stays loaded. Throws std::runtime_error that names the file, what
/// it is for, for example "draws charts", and its fault.
const void* loadedLibrary(const std::string& name, const char* offers, const std::string& whatItDoes);

}  // namespace carom
