/// \file
/// The readers without libFuzzer, for every run of the tests: each is offered its corpus, and so many inputs
/// that are made from it by the same random changes every time.
///
///     small CORPUS INPUTS

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using Reader = int(const std::uint8_t*, std::size_t);

// what the fuzz targets are called here: CMakeLists.txt
extern "C" {
Reader fuzz_chain, fuzz_experiment, fuzz_table, fuzz_samples, fuzz_values, fuzz_label, fuzz_seals,
    fuzz_report, fuzz_unfinished, fuzz_effects, fuzz_model, fuzz_draft;
}

namespace {

using Text = std::vector<std::uint8_t>;

std::vector<Text> corpus_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Text> texts;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

/// One to four changes: a byte is another, a part is lost, comes twice, or comes from another text.
class Changer {
 public:
  explicit Changer(const std::vector<Text>& corpus) : corpus_(&corpus) {}

  Text next() {
    Text text = any();
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return limit > 0 ? random_() % limit : 0; }
  const Text& any() { return (*corpus_)[below(corpus_->size())]; }

  static auto at(Text& text, std::size_t place) { return text.begin() + static_cast<std::ptrdiff_t>(place); }

  void change(Text& text) {
    static const std::string marks = "\"'[]{}<>=,;:#/\\+-.0123456789eE \n\t\r";
    const std::size_t place = below(text.size() + 1),
                      length = below(std::min<std::size_t>(text.size() - place, 40) + 1);
    const auto mark = static_cast<std::uint8_t>(
        below(8) == 0 ? below(256) : static_cast<std::size_t>(marks[below(marks.size())]));
    switch (below(5)) {
      case 0:
        if (place < text.size()) text[place] = mark;
        return;
      case 1:
        text.insert(at(text, place), mark);
        return;
      case 2:
        text.erase(at(text, place), at(text, place + length));
        return;
      case 3: {
        const Text part(at(text, place), at(text, place + length));
        text.insert(at(text, below(text.size() + 1)), part.begin(), part.end());
        return;
      }
      default: {
        Text other = any();
        const std::size_t from = below(other.size() + 1);
        text.resize(place);
        text.insert(text.end(), at(other, from), other.end());
      }
    }
  }

  const std::vector<Text>* corpus_;
  std::mt19937_64 random_{1};
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const std::pair<const char*, Reader*> readers[] = {
      {"chain", fuzz_chain},     {"experiment", fuzz_experiment}, {"table", fuzz_table},
      {"samples", fuzz_samples}, {"values", fuzz_values},         {"label", fuzz_label},
      {"seals", fuzz_seals},     {"report", fuzz_report},         {"unfinished", fuzz_unfinished},
      {"effects", fuzz_effects}, {"model", fuzz_model},           {"draft", fuzz_draft}};
  const int inputs = std::atoi(words[2]);
  for (const auto& [name, reader] : readers) {
    const std::vector<Text> corpus = corpus_of(std::filesystem::path(words[1]) / name);
    for (const Text& text : corpus) reader(text.data(), text.size());
    Changer changer(corpus);
    for (int i = 0; i < inputs; ++i) {
      const Text text = changer.next();
      reader(text.data(), text.size());
    }
    std::printf("%s: %zu kept, %d made\n", name, corpus.size(), inputs);
  }
}
