#include "diagnose/draft/word_table.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace plumbline::diagnose {
namespace {

struct WordRow {
  Meaning meaning;
  const char *english, *german, *french, *spanish, *chinese, *japanese;
};

/// Without capitals and accents.
constexpr WordRow rows[] = {
    {Meaning::time, "t time times timestamp stamp secs seconds ts clock elapsed", "zeit uhrzeit zeitpunkt",
     "temps heure", "tiempo hora", "时间 时刻", "時間 時刻"},
    {Meaning::force, "f fx fy fz force forces load wrench ft scale loadcell", "kraft last", "force charge",
     "fuerza carga", "力 载荷 负载", "力 荷重 負荷"},
    {Meaning::force_with_axis, "effort", "", "effort", "esfuerzo", "", ""},
    {Meaning::place,
     "travel traverse crosshead displacement extension stroke compression deflection pos position place",
     "weg hub auslenkung verformung durchbiegung lage", "deplacement course fleche",
     "desplazamiento recorrido carrera posicion", "位移 行程 位置", "変位 ストローク 位置"},
    {Meaning::angle, "q joint angle theta phi encoder enc jnt servo axis", "winkel gelenk achse",
     "angle articulation axe", "angulo articulacion eje", "角度 关节", "角度 関節"},
    {Meaning::torque, "torque tau moment", "drehmoment moment", "couple moment", "par momento",
     "扭矩 转矩 力矩", "トルク"},
    {Meaning::mass, "weight mass payload", "gewicht masse", "masse poids", "peso masa", "质量 重量",
     "質量 重量 重さ"},
    {Meaning::temperature, "temp temperature", "temperatur", "temperature", "temperatura", "温度", "温度"},
    {Meaning::humidity, "humidity humid rh", "feuchte", "humidite", "humedad", "湿度", "湿度"},
    {Meaning::current, "current amps", "strom", "courant", "corriente", "电流", "電流"},
    {Meaning::speed, "v vel velocity dq qd speed acc accel acceleration", "geschwindigkeit beschleunigung",
     "vitesse", "velocidad", "速度", "速度"},
    {Meaning::run, "run trial experiment rep repetition cycle", "versuch lauf", "essai", "ensayo", "试验",
     "試験"},
    {Meaning::number, "index nr no n id pose sample frame reading step count number line", "nummer messung",
     "numero", "numero", "序号", "番号"},
    {Meaning::command, "cmd command commanded des desired set setpoint target goal ref reference",
     "soll sollwert vorgabe", "consigne commande", "consigna orden", "指令 目标 设定", "指令 目標 設定"},
    {Meaning::reached, "reached actual measured feedback fb real", "ist istwert", "atteint reel mesure",
     "alcanzado medido real", "实际 实测", "実測"},
    {Meaning::motor, "motor", "motor antrieb", "moteur", "motor", "电机", "モータ"},
    {Meaning::raw, "raw adc counts ticks unfiltered", "roh", "brut", "crudo bruto", "原始", "生"},
    {Meaning::filtered, "filt filtered smooth smoothed mean avg", "gefiltert", "filtre", "filtrado", "滤波",
     "平均"},
};

struct WordsOfMeaning {
  std::set<std::string> whole;       ///< that stand alone
  std::vector<std::string> written;  ///< of scripts without blanks
};

std::map<Meaning, WordsOfMeaning> by_meaning() {
  std::map<Meaning, WordsOfMeaning> all;
  const auto each = [](const char* words, const auto& take) {
    std::istringstream in(words);
    for (std::string word; in >> word;) take(word);
  };
  for (const WordRow& row : rows) {
    WordsOfMeaning& of = all[row.meaning];
    for (const char* words : {row.english, row.german, row.french, row.spanish})
      each(words, [&](const std::string& word) { of.whole.insert(word); });
    for (const char* words : {row.chinese, row.japanese})
      each(words, [&](const std::string& word) { of.written.push_back(word); });
  }
  return all;
}

}  // namespace

bool says(const std::vector<std::string>& words, Meaning meaning) {
  static const std::map<Meaning, WordsOfMeaning> all = by_meaning();
  const WordsOfMeaning& of = all.at(meaning);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return of.whole.contains(word) ||
           std::any_of(of.written.begin(), of.written.end(),
                       [&](const std::string& part) { return word.find(part) != std::string::npos; });
  });
}

}  // namespace plumbline::diagnose
