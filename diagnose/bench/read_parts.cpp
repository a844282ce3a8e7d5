#include "diagnose/bench/read_parts.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

namespace plumbline::diagnose {
namespace {

constexpr const char* file_name = "the name of a sample file";

SamplePart read_part(const std::string& name, const std::string& place, SampleFormat format,
                     const ReadText& read) {
  NamedText file = read(name, place);
  SampleTable table = parse_sample_table(file.text, file.source, format);
  return {std::move(file.source), std::move(table), std::move(format)};
}

SamplePart read_part(const Section& part, const SampleFormat& format, const ReadText& read) {
  part.allow_only({"file", "csv", "columns"});
  return read_part(part.text("file", file_name), part.place("file"), read_sample_format(part, format), read);
}

}  // namespace

std::vector<SamplePart> read_parts(const Section& run, const SampleFormat& format, const ReadText& read) {
  const toml::array* const list = run.has("samples") ? run.node("samples").as_array() : nullptr;
  if (list == nullptr) return {read_part(run.text("samples", file_name), run.place("samples"), format, read)};
  const std::string expected = "names of sample files, or tables { file = …, csv = …, columns = … }";
  if (list->empty()) run.refuse("samples", expected);
  SampleFormat several = format;
  several.any_order = true;  // a channel is in one of them alone
  std::vector<SamplePart> parts;
  for (const toml::node& entry : *list) {
    const std::string path = fmt::format("samples[{}]", parts.size() + 1);
    if (const toml::table* table = entry.as_table()) {
      parts.push_back(read_part(run.entry(*table, path), several, read));
    } else if (const auto name = entry.value_exact<std::string>(); name && !name->empty()) {
      parts.push_back(read_part(*name, run.place("samples"), several, read));
    } else {
      run.refuse("samples", expected);
    }
  }
  return parts;
}

}  // namespace plumbline::diagnose
