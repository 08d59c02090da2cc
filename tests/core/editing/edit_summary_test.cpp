// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/editing/edit_list.h"

#include <QTest>

#include "tests/support/test_program.h"

namespace edit_summary_test {
using namespace gonio;
using namespace gonio::editing;

/// An edit of a model's default values, one parameter scaled.
Edit scaled(const char* model, const char* parameter, const Rgb& factor) {
  const models::Model& found = models::findModel(model);
  const models::ParameterValues values = models::defaultParameters(found.spec());
  DifferentialEdit edit{&found, values, values};
  edit.edited.values[*found.spec().find(parameter)] *= factor;
  return {edit};
}

class EditWordsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatNothingChangesHasNoWords() {
    const Edit same = scaled("ggx", "roughness", Rgb(1));
    QCOMPARE(editSummary(std::vector{same}), std::string());
    QCOMPARE(editedName("gold-paint", std::vector{same}), std::string("gold-paint"));
    Edit off = scaled("ggx", "roughness", Rgb(2));
    off.enabled = false;
    QCOMPARE(editSummary(std::vector{off}), std::string());
  }

  /// By what the parameters mean, whichever way round they are: a larger exponent is a narrower lobe.
  void widthsInEveryModel() {
    QCOMPARE(editedName("gold-paint", std::vector{scaled("ggx", "roughness", Rgb(2))}),
             std::string("gold-paint, rougher"));
    QCOMPARE(editSummary(std::vector{scaled("ggx", "roughness", Rgb(0.5))}), std::string("smoother"));
    QCOMPARE(editSummary(std::vector{scaled("blinn-phong", "exponent", Rgb(4))}), std::string("smoother"));
    QCOMPARE(editSummary(std::vector{scaled("ward", "roughness", Rgb(2))}), std::string("rougher"));
  }

  void coloursAndStrengths() {
    QCOMPARE(editSummary(std::vector{scaled("lambert", "diffuse", Rgb(2))}), std::string("lighter"));
    QCOMPARE(editSummary(std::vector{scaled("lambert", "diffuse", Rgb(2, 1, 0.5))}), std::string("recoloured"));
    Edit tinted = scaled("ggx", "roughness", Rgb(1));
    std::get<DifferentialEdit>(tinted.content).controls.values[std::size_t(ArtistControl::tint)] = Rgb(1, 0.5, 0.5);
    QCOMPARE(editSummary(std::vector{tinted}), std::string("recoloured"));
  }

  /// The user's own name stands for an edit; several edits are listed, each word once.
  void severalEdits() {
    Edit wet = scaled("ggx", "roughness", Rgb(0.5));
    wet.name = "wet/shiny";
    const Edit rough = scaled("ggx", "roughness", Rgb(2));
    QCOMPARE(editSummary(std::vector{wet, rough, rough}), std::string("wet/shiny, rougher"));
    QCOMPARE(editedName("a", std::vector{wet}), std::string("a, wet_shiny"));
  }
};

GONIO_TEST(EditWordsTest)
}  // namespace edit_summary_test

#include "edit_summary_test.moc"
