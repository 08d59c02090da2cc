// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/preferences.h"

#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <thread>

#include "app/gonio/document/autosave.h"
#include "app/gonio/document/history.h"
#include "app/gonio/library/thumbnail.h"
#include "core/math/parallel.h"
#include "widgets/panels/elided_label.h"
#include "widgets/parameters/parameter_panel.h"

namespace gonio::app {

namespace {

const QString themeKey = QStringLiteral("theme"), historyKey = QStringLiteral("history/megabytes"),
              threadsKey = QStringLiteral("threads"), roughnessKey = QStringLiteral("units/roughness"),
              squareRoot = QStringLiteral("square root");
constexpr int defaultHistoryMegabytes = int(History::defaultByteLimit >> 20), maxHistoryMegabytes = 1 << 14;

int coreCount() { return std::max(1, int(std::thread::hardware_concurrency())); }

QHBoxLayout* rowOf(QWidget* wide, QWidget* narrow) {
  auto* row = new QHBoxLayout;
  row->addWidget(wide, 1);
  row->addWidget(narrow);
  return row;
}

}  // namespace

Preferences Preferences::read(const QSettings& settings) {
  return {.theme = themeByName(settings.value(themeKey).toString()),
          .historyMegabytes =
              std::clamp(settings.value(historyKey, defaultHistoryMegabytes).toInt(), 1, maxHistoryMegabytes),
          .threads = std::clamp(settings.value(threadsKey, 0).toInt(), 0, coreCount()),
          .roughness = settings.value(roughnessKey).toString() == squareRoot ? widgets::RoughnessDisplay::squareRoot
                                                                             : widgets::RoughnessDisplay::alpha};
}

void Preferences::write(QSettings& settings) const {
  settings.setValue(themeKey, themeName(theme));
  settings.setValue(historyKey, historyMegabytes);
  settings.setValue(threadsKey, threads);
  settings.setValue(roughnessKey,
                    roughness == widgets::RoughnessDisplay::squareRoot ? squareRoot : QStringLiteral("alpha"));
}

void limitThreads(int threads) {
  static std::unique_ptr<ThreadLimit> limit;
  limit.reset();
  if (threads > 0) limit = std::make_unique<ThreadLimit>(threads);
}

void applyPreferences(const QSettings& settings, History& history) {
  const Preferences preferences = Preferences::read(settings);
  history.setByteLimit(std::size_t(preferences.historyMegabytes) << 20);
  limitThreads(preferences.threads);
  widgets::setRoughnessDisplay(preferences.roughness);
}

void showPreferences(QSettings& settings, History& history, const QString& graphics, QWidget* window) {
  const Preferences before = Preferences::read(settings);
  auto* dialog = new PreferencesDialog(before, graphics, window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QDialog::accepted, window, [&settings, &history, dialog, before] {
    const Preferences chosen = dialog->preferences();
    chosen.write(settings);
    applyPreferences(settings, history);
    if (chosen.theme != before.theme) applyTheme(*qApp, chosen.theme);
    if (chosen.roughness == before.roughness) return;
    for (const QWidget* one : QApplication::topLevelWidgets())
      for (auto* panel : one->findChildren<widgets::ParameterPanel*>()) panel->showUnits();
  });
  dialog->open();
}

PreferencesDialog::PreferencesDialog(const Preferences& preferences, const QString& graphics, QWidget* parent)
    : QDialog(parent),
      m_theme(new QComboBox),
      m_roughness(new QComboBox),
      m_history(new QSpinBox),
      m_threads(new QSpinBox),
      m_thumbnails(new QLabel) {
  setWindowTitle(tr("Preferences"));
  m_theme->addItems({tr("Follow the system"), tr("Light"), tr("Dark")});
  m_theme->setCurrentIndex(int(preferences.theme));
  m_roughness->addItems({tr("α, as in the models"), tr("√α, as in Blender and Unreal")});
  m_roughness->setCurrentIndex(int(preferences.roughness));
  m_roughness->setToolTip(tr("Convention for roughness in the section \"All parameters\"; does not change materials"));
  m_history->setRange(1, maxHistoryMegabytes);
  m_history->setSuffix(tr(" MB"));
  m_history->setValue(preferences.historyMegabytes);
  m_history->setToolTip(tr("Memory for undo in each window; the oldest steps are deleted first"));
  m_threads->setRange(0, coreCount());
  m_threads->setSpecialValueText(tr("All %1").arg(coreCount()));
  m_threads->setValue(preferences.threads);
  m_threads->setToolTip(tr("Number of threads for fits, exports and renderings"));
  auto* clear = new QPushButton(tr("&Clear"));
  clear->setAutoDefault(false);
  clear->setToolTip(tr("Deletes the stored thumbnails; they are rendered again when needed"));
  connect(clear, &QPushButton::clicked, this, &PreferencesDialog::clearThumbnails);
  auto* opengl = new QLabel(graphics.isEmpty() ? tr("Not started") : graphics);
  opengl->setTextInteractionFlags(Qt::TextSelectableByMouse);
  opengl->setTextFormat(Qt::PlainText);
  opengl->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* form = new QFormLayout;
  form->setVerticalSpacing(fontMetrics().height() / 2);
  form->addRow(tr("&Theme"), m_theme);
  form->addRow(tr("R&oughness"), m_roughness);
  form->addRow(tr("&Undo memory"), m_history);
  form->addRow(tr("Th&reads"), m_threads);
  form->addRow(tr("Thumbnails"), rowOf(m_thumbnails, clear));
  form->addRow(tr("Unsaved work"), folderRow(Autosave::defaultDataFolder()));
  form->addRow(tr("Settings"), folderRow(QFileInfo(QSettings().fileName()).absolutePath()));
  form->addRow(tr("OpenGL"), opengl);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addStretch();
  layout->addSpacing(fontMetrics().height());
  layout->addWidget(buttons);
  setMinimumWidth(fontMetrics().averageCharWidth() * 70);
  showThumbnailSize();
}

QWidget* PreferencesDialog::folderRow(const QString& folder) {
  auto* box = new QWidget;
  auto* path = new widgets::ElidedLabel(folder);
  path->setElideMode(Qt::ElideMiddle);
  path->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  path->setToolTip(folder);
  auto* show = new QPushButton(tr("Show"));
  show->setAutoDefault(false);
  connect(show, &QPushButton::clicked, this, [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
  auto* row = rowOf(path, show);
  row->setContentsMargins(0, 0, 0, 0);
  box->setLayout(row);
  return box;
}

void PreferencesDialog::showThumbnailSize() {
  qint64 bytes = 0;
  const QFileInfoList files = QDir(thumbnailCacheFolder()).entryInfoList(QDir::Files);
  for (const QFileInfo& file : files) bytes += file.size();
  m_thumbnails->setText(files.isEmpty() ? tr("None stored")
                                        : tr("%1 stored, %2")
                                              .arg(files.size())
                                              .arg(QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat)));
  m_thumbnails->setToolTip(thumbnailCacheFolder());
}

void PreferencesDialog::clearThumbnails() {
  QDir folder(thumbnailCacheFolder());
  for (const QString& file : folder.entryList({QStringLiteral("*.png")}, QDir::Files)) folder.remove(file);
  showThumbnailSize();
}

Preferences PreferencesDialog::preferences() const {
  return {Theme(m_theme->currentIndex()), m_history->value(), m_threads->value(),
          widgets::RoughnessDisplay(m_roughness->currentIndex())};
}

}  // namespace gonio::app

#include "moc_preferences.cpp"
