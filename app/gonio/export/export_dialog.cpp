// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/export/export_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/export/export_controller.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/icons.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {
constexpr int maxSide = 240, minSide = 120, gap = 12;
const QColor pictureGround(38, 38, 38);
}  // namespace

ExportPictures::ExportPictures(QWidget* parent) : QWidget(parent) {
  m_names[0] = tr("Material");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumSize(2 * minSide + gap, minSide + 2 * fontMetrics().height());
  setAccessibleName(tr("Material and export"));
}

QSize ExportPictures::sizeHint() const { return {2 * maxSide + gap, maxSide + 2 * fontMetrics().height()}; }

void ExportPictures::setPictures(const QImage& original, const QImage& exported) {
  m_pictures[0] = original;
  m_pictures[1] = exported;
  update();
}

void ExportPictures::setExportedName(const QString& name) {
  m_names[1] = name;
  update();
}

void ExportPictures::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const int line = fontMetrics().height() * 3 / 2;
  const int side = std::min({maxSide, (width() - gap) / 2, height() - line});
  const int left = (width() - 2 * side - gap) / 2, top = (height() - side - line) / 2;
  for (int i = 0; i < 2; ++i) {
    const QRect place(left + i * (side + gap), top, side, side);
    painter.fillRect(place, pictureGround);
    if (!m_pictures[i].isNull()) painter.drawImage(place, m_pictures[i]);
    const QRect text(place.left(), place.bottom() + 1, side, line);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(text, Qt::AlignCenter, fontMetrics().elidedText(m_names[i], Qt::ElideMiddle, side));
  }
}

namespace {

constexpr int trialDelayMilliseconds = 150;
enum Column { labelColumn, matchColumn, bytesColumn };
constexpr int targetRole = Qt::UserRole;  ///< index of the target of a row

QString groupTitle(exports::TargetGroup group) {
  switch (group) {
    case exports::TargetGroup::renderers:
      return ExportDialog::tr("Renderers");
    case exports::TargetGroup::engines:
      return ExportDialog::tr("Engines and DCC");
    default:
      return ExportDialog::tr("Tables and data");
  }
}

QString exportSnrText(double snr) {
  if (std::isnan(snr)) return ExportDialog::tr("not rendered");
  return std::isfinite(snr) ? ExportDialog::tr("%1 dB").arg(snr, 0, 'f', 1) : ExportDialog::tr("exact");
}

QString exportMatchText(const ExportTrial& trial) {
  return std::isnan(trial.made.snr) ? exportSnrText(trial.made.snr) : matchWord(trial.made.snr, trial.flip);
}

QString exportBytesText(std::uint64_t bytes) {
  return QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat);
}

}  // namespace

ExportDialog::ExportDialog(ExportController& controller, QSettings& settings, const rendering::Scene& scene,
                           QWidget* parent)
    : QDialog(parent),
      m_controller(controller),
      m_settings(settings),
      m_scene(std::make_shared<const rendering::Scene>(scene)),
      m_material(controller.document().edited()) {
  setWindowTitle(tr("Export for Renderer"));
  const int em = fontMetrics().height();
  resize(em * 62, em * 38);
  auto* columns = new QHBoxLayout;
  columns->addWidget(targetList(), 2);
  columns->addWidget(details(), 3);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
  m_export->setDefault(true);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(columns, 1);
  layout->addWidget(nameRow());
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  m_delay.setSingleShot(true);
  m_delay.setInterval(trialDelayMilliseconds);
  connect(&m_delay, &QTimer::timeout, this, &ExportDialog::startTrial);
  connect(&m_controller.tasks(), &BackgroundTasks::changed, this, &ExportDialog::showProgress);
  restore();
  connect(m_targets, &QTreeWidget::currentItemChanged, this, &ExportDialog::showTarget);
  connect(m_snr, &QDoubleSpinBox::valueChanged, this, &ExportDialog::showTarget);
  connect(m_withScene, &QCheckBox::toggled, this, &ExportDialog::showFiles);
  connect(m_name, &QLineEdit::textChanged, this, &ExportDialog::showFiles);
  showTarget();
  // The first target is made at once: the delay is for keys that pass by targets.
  m_delay.stop();
  if (!trial() || !trial()->isRefined) startTrial();
}

ExportDialog::~ExportDialog() { m_controller.dropTrial(); }

QWidget* ExportDialog::targetList() {
  m_targets = new QTreeWidget;
  m_targets->setHeaderLabels({tr("Target"), tr("Match"), tr("Size")});
  m_targets->setRootIsDecorated(false);
  m_targets->setUniformRowHeights(true);
  const int line = fontMetrics().height();
  m_targets->setIconSize({line * 5 / 4, line * 5 / 4});
  m_targets->setAccessibleName(tr("Target"));
  int widest = 0;
  QTreeWidgetItem* group = nullptr;
  const auto targets = exports::exportTargets();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i == 0 || targets[i].group != targets[i - 1].group) {
      group = new QTreeWidgetItem(m_targets, {groupTitle(targets[i].group)});
      group->setFlags(Qt::ItemIsEnabled);
      group->setSizeHint(labelColumn, {0, line * 3 / 2});  // of all rows
      QFont bold = font();
      bold.setBold(true);
      group->setFont(labelColumn, bold);
    }
    const QString label = widgets::toQString(targets[i].label);
    widest = std::max(widest, fontMetrics().horizontalAdvance(label));
    auto* item = new QTreeWidgetItem(group, {label});
    item->setData(labelColumn, targetRole, int(i));
    item->setIcon(labelColumn, widgets::themedIcon(widgets::toQString(targets[i].icon)));
    item->setToolTip(labelColumn, widgets::toQString(targets[i].purpose));
    item->setTextAlignment(bytesColumn, Qt::AlignRight | Qt::AlignVCenter);
  }
  m_targets->expandAll();
  m_targets->setItemsExpandable(false);
  m_targets->setIndentation(fontMetrics().height());
  m_targets->header()->setStretchLastSection(false);
  // Wide enough for all that they will hold: columns do not move while the targets are made.
  m_targets->header()->setSectionResizeMode(QHeaderView::Fixed);
  m_targets->header()->resizeSection(matchColumn, fontMetrics().horizontalAdvance(tr("indistinguishable")) + line);
  m_targets->header()->resizeSection(bytesColumn, fontMetrics().horizontalAdvance(QStringLiteral("100.0 MB")) + line);
  m_targets->header()->setSectionResizeMode(labelColumn, QHeaderView::Stretch);
  m_targets->setMinimumWidth(widest +
                             fontMetrics().horizontalAdvance(tr("indistinguishable") + QStringLiteral("100.0 MB")) +
                             6 * fontMetrics().height());
  return m_targets;
}

QWidget* ExportDialog::details() {
  auto* panel = new QWidget;
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  m_purpose = exportText();
  m_description = exportText();
  m_numbers = exportText();
  m_match = new QToolButton;
  m_match->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  m_match->setToolTip(tr("Shows the numbers, and what the files contain and can represent"));
  m_match->setAutoRaise(true);
  m_match->setCheckable(true);
  m_match->setFocusPolicy(Qt::StrongFocus);
  const auto showDetails = [this](bool shown) {
    m_match->setIcon(widgets::themedIcon(shown ? QStringLiteral("expanded") : QStringLiteral("collapsed")));
    m_numbers->setVisible(shown);
    m_description->setVisible(shown);
  };
  connect(m_match, &QToolButton::toggled, this, showDetails);
  m_pictures = new ExportPictures;
  m_warnings = exportText();
  m_progress = new QProgressBar;
  m_progress->setAccessibleName(tr("Progress of the preparation"));
  QSizePolicy kept = m_progress->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  m_progress->setSizePolicy(kept);
  m_snr = exportSnrField();
  m_withScene = new QCheckBox(tr("Also write a &scene"));
  m_withScene->setToolTip(
      tr("Adds a scene with the preview's shapes, lights, environment and camera, for Mitsuba, pbrt and Blender; a "
         "blurred background is not exported"));
  m_keep = new QCheckBox(tr("&Keep up to date"));
  m_keep->setToolTip(
      tr("Writes the files again whenever the edits have rested for a second, until another material is "
         "opened; File > Keep Export Up to Date switches it off"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Match at least"), m_snr);
  form->addRow(QString(), m_withScene);
  form->addRow(QString(), m_keep);
  layout->addWidget(m_purpose);
  layout->addLayout(form);
  layout->addWidget(m_pictures, 1);
  layout->addWidget(m_match);
  layout->addWidget(m_numbers);
  layout->addWidget(m_description);
  layout->addWidget(m_progress);
  layout->addWidget(m_warnings);
  showDetails(false);
  return panel;
}

QWidget* ExportDialog::nameRow() {
  auto* panel = new QWidget;
  auto* layout = new QFormLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  m_name = new QLineEdit;
  auto* browse = new QPushButton(tr("&Browse..."));
  browse->setAutoDefault(false);
  row->addWidget(m_name, 1);
  row->addWidget(browse);
  m_files = exportText();
  auto* label = new QLabel(tr("&Name:"));
  label->setBuddy(m_name);
  layout->addRow(label, row);
  layout->addRow(tr("Files:"), m_files);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
  return panel;
}

QString ExportDialog::proposedName() const {
  const Document& document = m_controller.document();
  return QString::fromStdString(exports::proposedName(document.name().toStdString(), document.describedEdits()));
}

void ExportDialog::restore() {
  m_snr->setValue(m_settings.value(export_settings::snr, exports::ExportOptions().snr).toDouble());
  m_withScene->setChecked(m_settings.value(export_settings::scene, false).toBool());
  const auto& last = m_controller.last();
  chooseTarget(last ? last->target->id : m_settings.value(export_settings::target).toString().toStdString());
  m_keep->setChecked(m_controller.isKeptUpToDate());
  setName(last ? last->name : QDir(startFolder()).filePath(proposedName()));
}

/// Beside the document; for a bundled material without one, where the last export went.
QString ExportDialog::startFolder() const {
  const QString beside = m_controller.document().folder();
  if (!beside.isEmpty()) return beside;
  const QString folder = m_settings.value(export_settings::folder).toString();
  return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

void ExportDialog::remember() {
  m_settings.setValue(export_settings::target, widgets::toQString(target().id));
  m_settings.setValue(export_settings::snr, m_snr->value());
  m_settings.setValue(export_settings::scene, m_withScene->isChecked());
  m_settings.setValue(export_settings::folder, QFileInfo(name()).absolutePath());
}

const exports::ExportTarget& ExportDialog::target() const {
  // The keyboard may make the title of a group current.
  const QTreeWidgetItem* current = m_targets->currentItem();
  if (!current->parent()) current = current->child(0);
  return exports::exportTargets()[std::size_t(current->data(labelColumn, targetRole).toInt())];
}

void ExportDialog::chooseTarget(std::string_view id) {
  const exports::ExportTarget* found = exports::findExportTarget(id);
  const auto index = found ? found - exports::exportTargets().data() : 0;
  for (QTreeWidgetItem* item : rows())
    if (item->data(labelColumn, targetRole).toInt() == int(index)) m_targets->setCurrentItem(item);
}

/// The rows of targets, without those of groups.
QList<QTreeWidgetItem*> ExportDialog::rows() const {
  QList<QTreeWidgetItem*> rows;
  for (int group = 0; group < m_targets->topLevelItemCount(); ++group)
    for (int row = 0; row < m_targets->topLevelItem(group)->childCount(); ++row)
      rows << m_targets->topLevelItem(group)->child(row);
  return rows;
}

QString ExportDialog::name() const {
  const QString text = QDir::fromNativeSeparators(m_name->text().trimmed());
  if (text.isEmpty()) return {};
  const auto path = target().nameOf(QFileInfo(QDir(startFolder()), text).absoluteFilePath().toStdString());
  return QString::fromStdString(path.string());
}

void ExportDialog::setName(const QString& name) { m_name->setText(QDir::toNativeSeparators(name)); }

exports::ExportOptions ExportDialog::options() const {
  exports::ExportOptions options;
  options.snr = m_snr->value();
  return options;
}

ExportTrialPtr ExportDialog::trial() const { return m_controller.known(m_material, target(), m_snr->value()); }

bool ExportDialog::withScene() const { return m_withScene->isEnabled() && m_withScene->isChecked(); }

void ExportDialog::showTarget() {
  m_purpose->setText(widgets::toQString(target().purpose));
  m_description->setText(widgets::toQString(target().description) + '\n' + widgets::toQString(target().limitations));
  m_snr->setEnabled(target().usesSnr);
  m_withScene->setEnabled(target().scene != nullptr);
  m_error.clear();
  m_controller.dropTrial();
  if (!trial() || !trial()->isRefined) m_delay.start();
  showTrial();
  showFiles();
}

void ExportDialog::startTrial() {
  m_controller.tryOut(
      m_material, target(), options(),
      [self = QPointer(this)] {
        if (self) self->showTrial();
      },
      [self = QPointer(this)](const QString& error) {
        if (!self) return;
        self->m_error = error;
        self->showTrial();
      });
}

void ExportDialog::showTrial() {
  for (QTreeWidgetItem* item : rows()) {
    const auto index = std::size_t(item->data(labelColumn, targetRole).toInt());
    const ExportTrialPtr of = m_controller.known(m_material, exports::exportTargets()[index], m_snr->value());
    const bool isMeasured = of && of->isRefined;
    item->setText(matchColumn, isMeasured ? exportMatchText(*of) : QString());
    item->setToolTip(matchColumn, isMeasured ? tr("Rendered SNR: %1").arg(exportSnrText(of->made.snr)) : QString());
    item->setText(bytesColumn, of ? exportBytesText(of->made.bytes()) : QString());
  }
  const ExportTrialPtr shown = trial();
  const QImage expected = shown ? QImage() : m_controller.expected(m_material, target());
  m_pictures->setPictures(m_controller.picture(m_material), shown ? shown->exported : expected);
  m_pictures->setExportedName(expected.isNull() ? tr("Export") : tr("Expected export"));
  QStringList numbers, warnings;
  if (!shown) {
    m_match->setText(m_error.isEmpty() ? tr("Preparing the export...") : m_error);
  } else if (!shown->isRefined) {
    m_match->setText(tr("Comparing the export with the material..."));
  } else if (!shown->made.brdf) {
    m_match->setText(tr("Values at individual directions; %1").arg(exportBytesText(shown->made.bytes())));
    numbers << tr("These files are not rendered.");
  } else {
    m_match->setText(tr("Match: %1; %2").arg(exportMatchText(*shown), exportBytesText(shown->made.bytes())));
    numbers << (std::isfinite(shown->made.snr)
                    ? tr("Rendered SNR %1, FLIP %2, BRDF SNR %3.")
                          .arg(exportSnrText(shown->made.snr), QString::number(shown->flip, 'f', 3),
                               exportSnrText(shown->made.brdfSnr))
                    : tr("Images of the export and of the material are identical."))
            << tr("Evaluated by Gonio, the files take %1.").arg(widgets::timesText(*shown->cost));
  }
  if (shown) {
    for (const std::string& loss : shown->made.losses) numbers << tr("Note: %1.").arg(QString::fromStdString(loss));
    for (const std::string& warning : shown->made.warnings)
      warnings << tr("Warning: %1.").arg(QString::fromStdString(warning));
  }
  m_numbers->setText(numbers.join(' '));
  m_warnings->setText(warnings.join('\n'));
  m_warnings->setVisible(!warnings.isEmpty());
  showProgress();
}

void ExportDialog::showProgress() {
  const auto fraction = m_controller.trialProgress();
  m_progress->setVisible(fraction.has_value());
  if (fraction) m_progress->setValue(int(100 * *fraction));
}

void ExportDialog::showFiles() {
  const QString path = name();
  m_export->setEnabled(!path.isEmpty());
  if (path.isEmpty()) return m_files->setText(tr("Enter a name."));
  bool exists = false;
  for (const auto& file : target().paths(path.toStdString(), writtenScene()))
    exists |= QFileInfo::exists(QString::fromStdString(file.string()));
  const QString files = fileNames(target(), path, writtenScene());
  m_files->setText(exists ? tr("%1 (replaces existing files)").arg(files) : files);
}

void ExportDialog::browse() {
  widgets::openFileDialog(widgets::newSaveDialog(this, tr("Export for Renderer"), name()), [this](const QString& file) {
    setName(QString::fromStdString(target().nameOf(file.toStdString()).string()));
  });
}

bool ExportDialog::mayReplace() {
  QStringList existing;
  for (const auto& file : target().paths(name().toStdString(), writtenScene()))
    if (const QFileInfo info(QString::fromStdString(file.string())); info.exists()) existing << info.fileName();
  return existing.isEmpty() ||
         widgets::ask(this, tr("Replace files"), tr("Replace %1?").arg(existing.join(QStringLiteral(", "))));
}

void ExportDialog::accept() {
  if (!mayReplace()) return;
  const ExportTrialPtr made = trial();
  m_controller.dropTrial();
  m_controller.write(m_material, {&target(), options(), name(), withScene() ? m_scene : nullptr}, made);
  m_controller.setKeptUpToDate(m_keep->isChecked());
  remember();
  QDialog::accept();
}

}  // namespace gonio::app

#include "moc_export_dialog.cpp"
