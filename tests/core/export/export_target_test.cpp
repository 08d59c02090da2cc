// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_target.h"

#include <QTest>
#include <set>

#include "core/editing/edit.h"
#include "core/models/registry.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace export_target_test {
using namespace gonio;
namespace fs = std::filesystem;

exports::ExportOptions small() { return {.snr = 20, .size = {{8, 16}}, .pictureSize = 24, .samples = 16}; }

class ExportTargetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The dialog, goniotool and the settings rely on these.
  void theTableIsWhole() {
    std::set<std::string_view> ids;
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      QVERIFY(ids.insert(target.id).second);
      QCOMPARE(exports::findExportTarget(target.id), &target);
      QVERIFY(!target.label.empty() && !target.description.empty() && !target.limitations.empty());
      QVERIFY(!target.suffixes.empty() && target.make);
      for (const std::string_view suffix : target.suffixes) QVERIFY(suffix.find('.') != std::string_view::npos);
    }
    QVERIFY(!exports::findExportTarget("no such renderer"));
  }

  void namesLoseWhatTheTargetAdds() {
    const exports::ExportTarget& target = *exports::findExportTarget("mitsuba");
    for (const char* file : {"a/chrome", "a/chrome_rgb.bsdf", "a/chrome_spec.bsdf", "a/chrome.bsdf"})
      QCOMPARE(target.nameOf(file), fs::path("a/chrome"));
    QCOMPARE(target.nameOf("a/chrome.v2"), fs::path("a/chrome.v2"));
    QCOMPARE(target.paths("a/b").at(1), fs::path("a/b_spec.bsdf"));
  }

  /// Every target makes files of all its suffixes, and states their accuracy by what they show.
  void everyTargetExports() {
    const auto source = materials::unedited("test", test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.5), 0.4, 0.05));
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      const exports::ExportResult made = exports::makeExport(target, source, small());
      QCOMPARE(made.parts.size(), target.suffixes.size());
      for (std::size_t i = 0; i < made.parts.size(); ++i) QCOMPARE(made.parts[i].suffix, target.suffixes[i]);
      QCOMPARE(exports::exportedFiles(made, "a/b").front().path, fs::path("a/b").concat(target.suffixes.front()));
      if (target.id == "csv" || target.id == "slices") {
        // Values, and no material whose accuracy could be stated.
        QVERIFY(!made.brdf && std::isnan(made.snr) && std::isnan(made.brdfSnr));
        QVERIFY(made.losses.at(0).find("nothing between them") != std::string::npos);
        continue;
      }
      QVERIFY2(made.snr > 20, target.id.data());
      const DirectionPair pair{glm::normalize(Direction(0.3, 0.2, 1)), glm::normalize(Direction(-0.4, 0.1, 1))};
      const double truth = source.shown.brdf->evaluate(pair.wi, pair.wo).x,
                   found = made.brdf->evaluate(pair.wi, pair.wo).x;
      QVERIFY2(std::abs(found / truth - 1) < 0.25, target.id.data());
    }
  }

  /// All files but those of formats without a place for it: MERL's and UTIA's.
  void filesCarryTheirOrigin() {
    materials::EditedMaterial source = materials::unedited("test", test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(0.5), 0.4, 0.05));
    source.base.name = "car";
    source.base.source = {.format = "MERL", .sha256 = "0badcafe"};
    const std::string origin = "Source: car (MERL), SHA-256 0badcafe. Edits: none";
    for (const exports::ExportTarget& target : exports::exportTargets()) {
      if (target.id == "merl" || target.id == "merl-360" || target.id == "utia") continue;
      for (const exports::ExportPart& part : exports::makeExport(target, source, small()).parts) {
        const std::string_view text(reinterpret_cast<const char*>(part.bytes.data()), part.bytes.size());
        QVERIFY2(text.find(origin) != std::string_view::npos, part.suffix.c_str());
        const bool approximates = target.id != "csv" && target.id != "slices";
        QVERIFY2(!approximates || text.find(" dB") != std::string_view::npos, part.suffix.c_str());
      }
    }
  }

  void energyAboveOneIsAWarning() {
    const auto source = materials::unedited("test", test::ggx(Rgb(1.2), Rgb(0), 0.4, 0.05));
    const exports::ExportResult made = exports::makeExport(*exports::findExportTarget("blender"), source, small());
    QCOMPARE(made.warnings.size(), std::size_t(1));
    QVERIFY(made.warnings.front().find("more light than it receives") != std::string::npos);
  }

  void proposedNamesSayWhatIsInTheFiles() {
    QCOMPARE(exports::proposedName("red car/paint", {}), std::string("red_car_paint"));
    // The targets add such an ending again.
    QCOMPARE(exports::proposedName("satin_purple_rgb", {}), std::string("satin_purple"));
    QCOMPARE(exports::proposedName("satin_purple_spec", {}), std::string("satin_purple"));
    const models::Model& model = models::findModel("lambert");
    const models::ParameterValues from{{Rgb(0.2)}}, to{{Rgb(0.4)}};
    const editing::EditList edits{{.content = editing::DifferentialEdit{&model, from, to}}};
    QCOMPARE(exports::proposedName("chrome", edits), std::string("chrome_lighter"));
  }
};

GONIO_TEST(ExportTargetTest)
}  // namespace export_target_test

#include "export_target_test.moc"
