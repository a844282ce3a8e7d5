#include "diagnose/bench/sample_format.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_samples.hpp"
#include "diagnose/bench/sample_columns.hpp"
#include "diagnose/bench/sample_table.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// The format of a chain of two joints with what these tables change.
SampleFormat format_of(const std::string& tables) {
  const toml::table parsed = files::parse_toml(tables, "F");
  return read_sample_format(Section(parsed, "F"), standard_format(2));
}

std::string format_fault(const std::string& tables) {
  try {
    format_of(tables);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

Samples sampled(const std::string& tables, const std::string& text, Control control = Control::end_point) {
  const SampleFormat format = format_of(tables);
  return read_samples({{"T", parse_sample_table(text, "T", format), format}}, control);
}

std::string sample_fault(const std::string& tables, const std::string& text,
                         Control control = Control::end_point) {
  try {
    sampled(tables, text, control);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The places of the columns of a chain.
enum : std::size_t { place_t, place_x, place_y, place_Fx, place_Fy, place_q1 };

const std::string one_source = "the name of a column, or its number from 1";

}  // namespace

TEST_CASE("defaults of the sample format") {
  const SampleFormat format = standard_format(2);
  CHECK(format.delimiter == ',');
  CHECK(format.decimal == '.');
  CHECK(format.header);
  CHECK(format.skip_lines == 0);
  CHECK(format.skip_after_header == 0);
  CHECK_FALSE(format.any_order);
  CHECK_FALSE(format.absolute_angles);
  const std::vector<std::string> names{"t",          "x",          "y",    "Fx",   "Fy",    "q1",   "q2",
                                       "q_command1", "q_command2", "Fx_2", "Fy_2", "tilt1", "tilt2"},
      units{"s", "m", "m", "N", "N", "rad", "rad", "rad", "rad", "N", "N", "rad", "rad"};
  REQUIRE(format.columns.size() == names.size());
  for (std::size_t c = 0; c < names.size(); ++c) {
    CHECK(format.columns[c].channel == names[c]);
    CHECK(format.columns[c].name == names[c]);
    CHECK(format.columns[c].number == 0);
    CHECK(format.columns[c].unit.name == units[c]);
    CHECK(format.columns[c].place.empty());
    CHECK(format.columns[c].as_is());
  }
}

TEST_CASE("the table [csv]: every delimiter, both decimals, and nothing else") {
  const auto delimiter = [](const std::string& word) {
    return format_of("[csv]\ndelimiter = \"" + word + "\"\n").delimiter;
  };
  CHECK(delimiter(";") == ';');
  CHECK(delimiter("|") == '|');
  CHECK(delimiter(",") == ',');
  CHECK(delimiter("tab") == '\t');
  CHECK(delimiter("blanks") == ' ');
  CHECK(format_fault("[csv]\ndelimiter = \":\"\n") ==
        R"(F:2: csv.delimiter: found ':', expected ",", ";", "|", "tab" or "blanks")");
  CHECK(format_of("[csv]\ndecimal = \",\"\n").decimal == ',');
  CHECK(format_of("[csv]\ndecimal = \".\"\n").decimal == '.');
  CHECK(format_fault("[csv]\ndecimal = \"'\"\n") == R"(F:2: csv.decimal: found "'", expected "." or ",")");
  CHECK_FALSE(format_of("[csv]\nheader = false\n").header);
  CHECK(format_of("[csv]\nskip_lines = 2\n").skip_lines == 2);
  CHECK(format_of("[csv]\nskip_after_header = 3\n").skip_after_header == 3);
  CHECK(format_of("[csv]\ncomment = \"#\"\n").comment == "#");
  CHECK(format_of("[csv]\nmissing = \"-\"\n").missing == std::vector<std::string>{"-"});
  CHECK_FALSE(format_of("[csv]\n").any_order);
  CHECK(format_fault("[csv]\nseparator = \";\"\n").starts_with("F:2: csv.separator: found an unknown key"));
}

TEST_CASE("the table [columns]: a name, a number, or a table of what a column means") {
  const SampleFormat format = format_of(R"([columns]
t = 3
x = "pos"
Fx = { column = "load", unit = "mN", sign = -1, zero = 12.5 }
Fy = { constant = 0.25, unit = "kN" }
q = { column = ["a", 5], unit = "deg", sign = [1, -1], zero = "first", absolute = true }
)");
  CHECK(format.any_order);
  CHECK(format.absolute_angles);
  const std::vector<Column>& columns = format.columns;
  CHECK(columns[place_t].number == 3);
  CHECK(columns[place_t].name.empty());
  CHECK(columns[place_t].place == "F:2: columns.t");
  CHECK(columns[place_x].name == "pos");
  CHECK(columns[place_x].number == 0);
  CHECK(columns[place_y].name == "y");
  CHECK(columns[place_y].place.empty());
  CHECK(columns[place_Fx].name == "load");
  CHECK(columns[place_Fx].unit.in_si() == 1e-3);
  CHECK(columns[place_Fx].sign == -1);
  CHECK(columns[place_Fx].zero == "12.5");
  CHECK_FALSE(columns[place_Fx].zero_is_first);
  CHECK_FALSE(columns[place_Fx].as_is());
  CHECK(columns[place_Fy].constant == "0.25");
  CHECK(columns[place_Fy].unit.in_si() == 1000);
  CHECK(columns[place_q1].name == "a");
  CHECK(columns[place_q1].sign == 1);
  CHECK(columns[place_q1].zero_is_first);
  CHECK(columns[place_q1 + 1].name.empty());
  CHECK(columns[place_q1 + 1].number == 5);
  CHECK(columns[place_q1 + 1].sign == -1);
  CHECK(columns[place_q1 + 1].unit.name == "deg");
  // one of each for all, and one for each
  const SampleFormat spread = format_of("[columns]\nq = { column = [1, 2], sign = -1, zero = [0.1, 0.2] }\n");
  CHECK(spread.columns[place_q1].sign == -1);
  CHECK(spread.columns[place_q1 + 1].sign == -1);
  CHECK(spread.columns[place_q1].zero == "0.1");
  CHECK(spread.columns[place_q1 + 1].zero == "0.2");
  CHECK_FALSE(spread.absolute_angles);
  CHECK_FALSE(format_of("[columns]\nq = [1, 2]\n").absolute_angles);
}

TEST_CASE("an invalid table [columns] is refused at its key") {
  CHECK(format_fault("[columns]\nx = 0\n") == "F:2: columns.x: found 0, expected " + one_source);
  CHECK(format_of("[columns]\nx = 1\n").columns[place_x].number == 1);
  CHECK(format_fault("[columns]\nx = \"\"\n") == "F:2: columns.x: found '', expected " + one_source);
  CHECK(format_fault("[columns]\nx = 1.5\n") == "F:2: columns.x: found 1.5, expected " + one_source);
  CHECK(format_fault("[columns]\nq = [1]\n") ==
        "F:2: columns.q: found [ 1 ], expected a list of 2, each " + one_source);
  CHECK(format_fault("[columns]\nq = 1\n") ==
        "F:2: columns.q: found 1, expected a list of 2, each " + one_source);
  CHECK(format_fault("[columns]\nx = { sign = 2 }\n") == "F:2: columns.x.sign: found 2, expected 1 or -1");
  CHECK(format_fault("[columns]\nx = { zero = \"last\" }\n") ==
        "F:2: columns.x.zero: found 'last', expected a number, or \"first\"");
  CHECK(format_fault("[columns]\nx = { zero = [1] }\n").empty());
  CHECK(format_fault("[columns]\nq = { column = [1, 2], zero = true }\n") ==
        "F:2: columns.q.zero: found true, expected a number, or a list of 2");
  for (const char* beside : {"column = 1", "sign = 1", "zero = 0"})
    CHECK(format_fault(std::string("[columns]\nx = { constant = 1, ") + beside + " }\n")
              .ends_with("expected nothing beside a constant but its unit"));
  CHECK(format_fault("[columns]\nx = { absolute = true }\n")
            .starts_with("F:2: columns.x.absolute: found an unknown"));
  CHECK(format_fault("[columns]\nq = { constant = 1 }\n")
            .starts_with("F:2: columns.q.constant: found an unknown"));
  CHECK(format_fault("[columns]\nz = 1\n").starts_with("F:2: columns.z: found an unknown key"));
}

TEST_CASE("skipped lines count in line numbers") {
  const std::string tables =
      "[csv]\ndelimiter = \"blanks\"\ncomment = \"#\"\nskip_lines = 1\n"
      "skip_after_header = 1\n[columns]\n";
  const SampleFormat format = format_of(tables);
  const SampleTable table =
      parse_sample_table("title\n  # note\n  x   y\tt\r\nm m s\n1 2  3\n#\n4 5 6 \n", "T", format);
  CHECK(table.header == std::vector<std::string>{"x", "y", "t"});
  CHECK(table.header_line == 3);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].fields == std::vector<std::string>{"1", "2", "3"});
  CHECK(table.rows[0].line == 5);
  CHECK(table.rows[1].line == 7);
  CHECK(table.rows[1].fields == std::vector<std::string>{"4", "5", "6"});
}

TEST_CASE("a sample table: byte order mark, trailing delimiters, equal lengths of rows") {
  const SampleFormat plain = standard_format(2);
  const SampleTable table = parse_sample_table("\xEF\xBB\xBFx,y,,\n1,2,,,\n3,,\n", "T", plain);
  CHECK(table.header == std::vector<std::string>{"x", "y"});
  CHECK(table.header_line == 1);
  CHECK(table.rows[0].fields == std::vector<std::string>{"1", "2"});
  CHECK(table.rows[1].fields == std::vector<std::string>{"3", ""});
  const auto fault = [](const std::string& text, const SampleFormat& format) -> std::string {
    try {
      parse_sample_table(text, "T", format);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CHECK(fault("x,y\n", plain) == "T: found a header alone, expected at least one reading");
  CHECK(fault("x,y\n1,2\n3\n", plain) == "T:3: found 1 fields, expected 2, as in the header");
  CHECK(fault("made by\n1,2\n", plain) ==
        "T:2: found 2 fields, expected 1, as in the header; a name for every column in line 1");
  CHECK(fault("made by\nx,y\n1,2\n", plain) ==
        "T:2: found 2 fields, expected 1, as in the header; if the header is line 2: csv.skip_lines = 1");
  CHECK(fault("x,y\n0,45,0,02\n", plain) ==
        "T:2: found 4 fields, expected 2, as in the header; where commas are decimal marks: another mark "
        "between the columns");
  // as many delimiters of another kind as would make more columns
  CHECK(fault("a;b;c\n1,2\n", plain) ==
        "T:2: found 2 fields, expected 1, as in the header; csv.delimiter = \";\" would read more columns "
        "there");
  SampleFormat bare = plain;
  bare.header = false;
  CHECK(fault("1,2\n3,4,5\n", bare) == "T:2: found 3 fields, expected 2, as in the first line");
  CHECK(parse_sample_table("1,2\n3,4\n", "T", bare).rows.size() == 2);
  CHECK(parse_sample_table("1,2\n3,4\n", "T", bare).header.empty());
  bare.skip_after_header = 5;
  CHECK(fault("1,2\n3,4\n", bare) == "T: found no line, expected at least one reading");
}

TEST_CASE("a better delimiter is suggested") {
  const auto other = [](std::vector<std::string> header, char delimiter) {
    SampleFormat format = standard_format(1);
    format.delimiter = delimiter;
    return other_delimiter({std::move(header), 1, {}}, format);
  };
  CHECK(other({"a;b;c"}, ',') == "; csv.delimiter = \";\" would read more columns there");
  CHECK(other({"a;b"}, ',').empty());
  CHECK(other({"a\tb\tc"}, ';') == "; csv.delimiter = \"tab\" would read more columns there");
  CHECK(other({"a|b|c"}, ';') == "; csv.delimiter = \"|\" would read more columns there");
  CHECK(other({"a,b,c"}, ';') == "; csv.delimiter = \",\" would read more columns there");
  CHECK(other({"a;b", "c;d;e"}, ',') == "; csv.delimiter = \";\" would read more columns there");
  CHECK(other({"a;b;c"}, ';').empty());
}

TEST_CASE("columns are found by their number, by their name, or in the standard order") {
  const std::string named = "[columns]\nt = { constant = 0 }\nx = 2\ny = \"h\"\n";
  const SampleFormat format = format_of(named);
  const SampleTable table = parse_sample_table("a,b,h\n1,2,3\n", "T", format);
  const ColumnPlaces places = column_places({{"T", table, format}}, Control::end_point).front();
  using Place = std::optional<std::size_t>;
  CHECK(places == ColumnPlaces{Place(), Place(1), Place(2), Place(), Place(), Place(), Place(), Place(),
                               Place(), Place(), Place(), Place(), Place()});
  CHECK(column_title(table, 1) == "b");
  SampleFormat bare = standard_format(2);
  bare.header = false;
  const SampleTable numbers = parse_sample_table("0,1,2,3,4\n", "T", bare);
  CHECK(column_places({{"T", numbers, bare}}, Control::force).front() ==
        ColumnPlaces{Place(0), Place(1), Place(2), Place(3), Place(4), Place(), Place(), Place(), Place(),
                     Place(), Place(), Place(), Place()});
  CHECK(column_title(numbers, 1) == "column 2");
}

TEST_CASE("a missing column is refused") {
  const std::string header = "T:1: found the header 'a,b,h', expected ";
  CHECK(sample_fault("", "a,b,h\n1,2,3\n") ==
        header +
            "'t,x,y,Fx,Fy' or 't,x,y,Fx,Fy,q1,q2', or a table [columns] that says which column is which");
  CHECK(sample_fault("[columns]\nx = 4\n", "a,b,h\n1,2,3\n") ==
        "T:1: found 3 columns, expected a column 4, which F:2: columns.x names");
  CHECK(sample_fault("[columns]\nx = \"k\"\n", "a,b,h\n1,2,3\n") ==
        header + "one column 'k', which F:2: columns.x names");
  CHECK(sample_fault("[columns]\nx = \"a\"\n", "a,a,h\n1,2,3\n") ==
        "T:1: found 2 columns of one name, expected one column 'a', which F:2: columns.x names; a number "
        "says which one");
  CHECK(sample_fault("[columns]\n", "x,y,y\n1,2,3\n") ==
        "T:1: found 2 columns of one name, expected one column 'y'; a number says which one");
  CHECK(sample_fault("[columns]\nx = \"a\"\n", "a,b,h\n1,2,3\n") ==
        "T:1: found no column 'y', which the run imposes, expected the column, or a key columns.y that names "
        "another");
  CHECK(sample_fault("[columns]\nFx = \"a\"\n", "a,b,h\n1,2,3\n", Control::force)
            .starts_with("T:1: found no column 'Fy'"));
  CHECK(sample_fault("[columns]\n", "x,y,q1\n1,2,3\n") ==
        "T:1: found 1 of the columns q1, q2, expected all 2, or none");
  CHECK(sample_fault("[csv]\nheader = false\n[columns]\nx = 4\n", "1,2,3\n") ==
        "T:1: found 3 columns, expected a column 4, which F:4: columns.x names");
}

TEST_CASE("readings: signs, zeros, units, decimal commas, gaps, and absolute angles") {
  const std::string tables = R"([csv]
delimiter = ";"
decimal = ","
missing = "-"
[columns]
x = { column = "x", unit = "mm", sign = -1, zero = "first" }
y = { constant = 20, unit = "mm" }
q = { column = ["q1", "q2"], absolute = true }
)";
  const Samples samples = sampled(tables, "x;Fx;q1;q2\n300,5;+1,5;0,25;0,75\n298;-;0,5;-\n");
  REQUIRE(samples.readings.size() == 2);
  const Reading &first = samples.readings[0], &second = samples.readings[1];
  CHECK(first.t == 0);  // counted where there is no time
  CHECK(second.t == 1);
  CHECK(first[column_x] == 0);
  CHECK(second[column_x] == 0.0025);
  CHECK(first[column_y] == 0.02);
  CHECK(second[column_y] == 0.02);
  CHECK(first[column_Fx] == 1.5);
  CHECK(std::isnan(second[column_Fx]));
  CHECK(std::isnan(first[column_Fy]));
  CHECK(first.angles(2) == std::vector<double>{0.25, 0.5});
  CHECK(second[column_q + 0] == 0.5);
  CHECK(std::isnan(second[column_q + 1]));
  REQUIRE(samples.origins.size() == 13);  // commanded angles, a second sensor, tilts among them
  CHECK(samples.origins[place_t].source.empty());
  CHECK(samples.origins[place_x].source == "x");
  CHECK(samples.origins[place_x].what == "x");
  CHECK(samples.origins[place_x].unit == "mm");
  CHECK(samples.origins[place_x].in_si == 1e-3);
  CHECK(samples.origins[place_y].source == "constant 20");
  CHECK(samples.origins[place_q1 + 1].what == "q2");
}

TEST_CASE("the first present reading of a column is its zero") {
  const Samples samples =
      sampled("[columns]\nFx = { column = \"F\", zero = \"first\" }\n", "x,y,F\n1,2,\n1,2,7\n1,2,9\n");
  CHECK(std::isnan(samples.readings[0][column_Fx]));
  CHECK(samples.readings[1][column_Fx] == 0);
  CHECK(samples.readings[2][column_Fx] == 2);
}

TEST_CASE("an invalid number or reading is refused at its line") {
  const std::string all = "t,x,y,Fx,Fy\n";
  CHECK(sample_fault("", all + "0,1,2,1e,4\n") ==
        "T:2, Fx: found '1e', expected a finite number or an empty field");
  CHECK(sample_fault("", all + "0,1,2,inf,4\n") ==
        "T:2, Fx: found 'inf', expected a finite number or an empty field");
  CHECK(sample_fault("[csv]\ndelimiter = \";\"\n", "t;x;y;Fx;Fy\n0;1;2;3,5;4\n") ==
        "T:2, Fx: found '3,5', expected a finite number or an empty field; csv.decimal = \",\" reads decimal "
        "commas");
  CHECK(sample_fault("[csv]\ndelimiter = \";\"\ndecimal = \",\"\n", "t;x;y;Fx;Fy\n0;1;2;3.5;4\n") ==
        "T:2, Fx: found '3.5', expected a finite number or an empty field");
  CHECK(sample_fault("", all + ",1,2,3,4\n") ==
        "T:2, t: found an empty field, expected the time of the reading");
  CHECK(sample_fault("", all + "0,1,,3,4\n") ==
        "T:2: found an empty imposed channel, expected the commanded x and y");
  CHECK(sample_fault("", all + "0,,2,3,4\n") ==
        "T:2: found an empty imposed channel, expected the commanded x and y");
  CHECK(sample_fault("", all + "0,1,2,,4\n").empty());
  CHECK(sample_fault("", all + "0,1,2,,4\n", Control::force) ==
        "T:2: found an empty imposed channel, expected the commanded Fx and Fy");
  CHECK(sample_fault("", all + "0,1,2,3,\n", Control::force) ==
        "T:2: found an empty imposed channel, expected the commanded Fx and Fy");
  CHECK(sample_fault("", all + "0,,,3,4\n", Control::force).empty());
  CHECK(sample_fault("", all + "0,1,2,3,4\n1,1,2,3,4\n0.5,1,2,3,4\n") ==
        "T:4, t: found 0.5, expected a time not before the last reading's, 1; where the "
        "table goes back in time: its rows turned round");
  CHECK(sample_fault("", all + "0,1,2,3,4\n0,1,2,3,4\n").empty());
}
