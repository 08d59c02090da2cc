// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/inspector.h"

#include <QTest>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace edit_arguments_test {
using namespace gonio;
using namespace gonio::app;

class EditArgumentsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void onlyWhatChangesIsNamed() {
    const models::Model& model = models::ggx();
    editing::DifferentialEdit edit;
    edit.model = &model;
    edit.fitted = edit.edited = models::defaultParameters(model.spec());
    QCOMPARE(editArguments(edit), QStringLiteral("--model ggx --compose additive"));
    edit.composition = editing::Composition::lobes;
    edit.edited.values[*model.spec().find("roughness")] = Rgb(0.1 + 0.2);
    edit.edited.values[*model.spec().find("fresnel")] = Rgb(1);
    edit.controls.values[std::size_t(editing::ArtistControl::tint)] = Rgb(1, 0.5, 1e-17);
    const QString choice = QString::fromUtf8(model.spec().parameters[*model.spec().find("fresnel")].choices[1].data());
    QCOMPARE(editArguments(edit), QStringLiteral("--model ggx --set roughness=0.30000000000000004 --set fresnel=%1 "
                                                 "--control tint=1,0.5,1e-17 --compose lobes --change-albedo")
                                      .arg(choice));
    edit.keepsAlbedo = true;
    QVERIFY(editArguments(edit).endsWith("--compose lobes"));
  }
};

GONIO_TEST(EditArgumentsTest)
}  // namespace edit_arguments_test

#include "edit_arguments_test.moc"
