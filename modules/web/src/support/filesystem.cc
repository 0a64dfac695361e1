#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

// What libc++'s headers of files (with_files.hh) call and its library hasn't, over the functions of wasi-libc.
// JavaScript keeps the files in memory (page/src/memory_files.js): there are no links and no permissions, and a folder
// is there while a file is in it.

template class std::basic_filebuf<char>;
template class std::basic_ifstream<char>;
template class std::basic_ofstream<char>;

_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM
namespace {

/// \return whether a call has failed, which is in `error` then
bool tell(bool has_failed, error_code* error) {
  const error_code what = has_failed ? error_code(errno, generic_category()) : error_code();
  if (error != nullptr) *error = what;
  if (has_failed && error == nullptr) __throw_system_error(errno, "filesystem");
  return has_failed;
}

}  // namespace

file_status __status(const path& file, error_code* error) {
  struct stat found {};
  const bool has_failed = ::stat(file.empty() ? "." : file.c_str(), &found) != 0;
  if (has_failed && errno == ENOENT) {
    if (error != nullptr) *error = error_code(ENOENT, generic_category());
    return file_status(file_type::not_found);
  }
  if (tell(has_failed, error)) return file_status(file_type::none);
  return file_status(S_ISDIR(found.st_mode) ? file_type::directory : file_type::regular, perms::all);
}

file_status __symlink_status(const path& file, error_code* error) { return __status(file, error); }

path __read_symlink(const path& file, error_code* error) {
  tell(false, error);
  return file;
}

uintmax_t __file_size(const path& file, error_code* error) {
  struct stat found {};
  if (tell(::stat(file.c_str(), &found) != 0, error)) return static_cast<uintmax_t>(-1);
  return static_cast<uintmax_t>(found.st_size);
}

void __permissions(const path& /*file*/, perms /*of*/, perm_options /*how*/, error_code* error) { tell(false, error); }

bool __create_directories(const path& /*folder*/, error_code* error) {
  tell(false, error);
  return false;
}

bool __remove(const path& file, error_code* error) {
  const bool has_failed = ::unlink(file.c_str()) != 0;
  return !tell(has_failed && errno != ENOENT, error) && !has_failed;
}

void __rename(const path& from, const path& to, error_code* error) {
  tell(std::rename(from.c_str(), to.c_str()) != 0, error);
}

path __absolute(const path& file, error_code* error) {
  tell(false, error);
  return file.is_absolute() ? file : "/" / file;
}

path __weakly_canonical(const path& file, error_code* error) { return __absolute(file, error).lexically_normal(); }

bool __equivalent(const path& a, const path& b, error_code* error) {
  return __weakly_canonical(a, error) == __weakly_canonical(b, error);
}

_LIBCPP_END_NAMESPACE_FILESYSTEM
