// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/inspector/representation_panel.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/dictionary/decode.h"
#include "core/formats/code.h"
#include "core/metrics/brdf_metrics.h"
#include "tests/app/gonio/glossy_material.h"
#include "tests/support/test_program.h"

namespace representation_panel_test {
using namespace gonio;
using namespace gonio::app;
using namespace gonio::app::test_support;

double logErrorOf(const MaterialCode& code) { return code.quality.errors[std::size_t(metrics::BrdfMetric::log)]; }

class RepresentationPanelTest : public QObject {
  Q_OBJECT
 private:
  BackgroundTasks m_tasks;
  Document m_document;
  std::unique_ptr<RepresentationPanel> m_panel;

  QString texts() const {
    QStringList all;
    for (const QLabel* label : m_panel->findChildren<QLabel*>()) all << label->text();
    return all.join('\n');
  }
  void settle() const { QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), patienceMilliseconds); }

 private Q_SLOTS:
  void init() {
    m_panel = std::make_unique<RepresentationPanel>(m_document, m_tasks);
    m_panel->setCoefficients(32);
    settle();
  }
  void cleanup() { m_panel.reset(); }

  /// While folded it computes nothing; then it shows what was measured of the code's file.
  void tellsWhatTheCodeIs() {
    m_document.setMaterial(glossyMaterial(0.3));
    QTest::qWait(50);
    QVERIFY(m_panel->isSettled() && !m_panel->code());
    m_panel->show();
    QVERIFY(!m_panel->isSettled());
    settle();
    const auto code = m_panel->code();
    QVERIFY(code);
    const auto dictionary = materials::bundledEnsemble();
    const dictionary::Encoder encoder(dictionary->ensemble);
    const auto expected = encoder.encode(*m_document.material()->table(), {.coefficients = 32, .quantised = true});
    const auto file = formats::encodeCode(expected.code, dictionary->id);
    const auto table = dictionary::decode(dictionary->ensemble, formats::readCode(io::MemorySource(file)).code);
    QCOMPARE(code->bytes, file.size());
    QVERIFY(std::ranges::equal(code->table->values(), table->values()));
    QCOMPARE(code->encoded.code.transform, expected.code.transform);
    QCOMPARE(logErrorOf(*code), metrics::brdfError(metrics::BrdfMetric::log, *m_document.material()->table(), *table));
    const QString reported = texts();
    QVERIFY(reported.contains(QString::number(logErrorOf(*code), 'g', 3)));
    QVERIFY(reported.contains(QString::number(code->quality.renderedSnr, 'f', 1) + " dB"));
    QVERIFY(reported.contains(" per evaluation, ") && reported.contains(" per frame, "));
    QVERIFY(reported.contains(QString::number(double(file.size()) * 1e-3, 'f', 1) + " kB"));
    for (const auto& candidate : expected.candidates)
      QVERIFY2(reported.contains(QString::number(candidate.gammaError, 'g', 3)), qPrintable(reported));
    for (const auto& channel : expected.code.channels)
      QVERIFY(reported.contains(QStringLiteral("no. %1 ").arg(channel.dictionary)));
  }

  /// The file has the bytes of the code that is shown.
  void theCodeIsSaved() {
    m_document.setMaterial(glossyMaterial(0.3));
    m_panel->show();
    settle();
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.code");
    QSignalSpy saved(m_panel.get(), &RepresentationPanel::saveRequested);
    for (QPushButton* button : m_panel->findChildren<QPushButton*>())
      if (button->text().contains("Save")) button->click();
    QCOMPARE(saved.count(), 1);
    saved[0][0].value<FileSave>().write(path.toStdString(), {});
    QCOMPARE(std::size_t(QFileInfo(path).size()), m_panel->code()->bytes);
  }

  /// The slider: more coefficients, more bytes, a smaller error; no number of another count is shown as this one's.
  void moreCoefficientsExplainMore() {
    m_panel->show();
    settle();
    const auto few = m_panel->code();
    m_panel->findChild<QSlider*>()->setValue(m_panel->findChild<QSlider*>()->value() + 3);
    QVERIFY(m_panel->coefficients() > 32);
    for (const QLabel* label : m_panel->findChildren<QLabel*>())
      if (label->text().contains(" kB")) QVERIFY(!label->isEnabled());
    settle();
    const auto more = m_panel->code();
    QCOMPARE(more->coefficients, m_panel->coefficients());
    QVERIFY(logErrorOf(*more) < logErrorOf(*few) && more->bytes > few->bytes);
    QVERIFY(m_document.history().count() == 0);
  }

  /// The switch works folded away too, follows the material, and lets go.
  void theSwitchAsksForTheCode() {
    QSignalSpy changed(m_panel.get(), &RepresentationPanel::shownChanged);
    QVERIFY(!m_panel->shown());
    m_panel->showEncoded().setChecked(true);
    settle();
    QVERIFY(m_panel->shown() && m_panel->shown()->material == m_document.material());
    QVERIFY(changed.count() >= 1);
    m_document.setMaterial(glossyMaterial(0.1));
    QVERIFY(!m_panel->shown());
    settle();
    QVERIFY(m_panel->shown()->material == m_document.material());
    const auto count = changed.count();
    m_panel->showEncoded().setChecked(false);
    QVERIFY(!m_panel->shown());
    QCOMPARE(changed.count(), count + 1);
  }

  /// Asking again for what is being encoded does not begin it anew; another count does.
  void aRunningEncodingGoesOn() {
    m_document.setMaterial(glossyMaterial(0.2));
    m_panel->show();
    QVERIFY(!m_panel->isSettled());
    QSignalSpy started(&m_tasks, &BackgroundTasks::changed);  // the progress comes by a timer, so not in here
    m_panel->showEncoded().setChecked(true);
    m_panel->hide();
    m_panel->show();
    QCOMPARE(started.count(), 0);
    m_panel->setCoefficients(48);
    QTRY_VERIFY_WITH_TIMEOUT(started.count() > 0, patienceMilliseconds);
    settle();
    QCOMPARE(m_panel->shown()->coefficients, std::size_t(48));
  }

  /// A table over another grid has no code: reported where the numbers would be.
  void anotherGridIsTold() {
    m_document.setMaterial(glossyMaterial(0.3, {24, 24, 24}));
    m_panel->show();
    settle();
    QVERIFY(!m_panel->code());
    QVERIFY2(texts().contains("grid"), qPrintable(texts()));
    m_document.setMaterial(glossyMaterial(0.3));
    settle();
    QVERIFY(m_panel->code());
  }

  /// After a stop it says so, and the button starts it again.
  void aStoppedEncodingCanBeBegunAgain() {
    m_panel->show();
    m_tasks.cancelTopmost();
    settle();
    QVERIFY(!m_panel->code());
    auto* button = m_panel->findChild<QPushButton*>();
    QVERIFY(button->isVisible());
    button->click();
    settle();
    QVERIFY(m_panel->code() && !button->isVisible());
  }
};

GONIO_TEST(RepresentationPanelTest)
}  // namespace representation_panel_test

#include "representation_panel_test.moc"
