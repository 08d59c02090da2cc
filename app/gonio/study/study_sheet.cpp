// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_sheet.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/library/thumbnail.h"
#include "core/io/atomic_file.h"
#include "core/study/accuracy_study.h"
#include "core/study/study_plot.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

const QString pictureFolder = QStringLiteral("plot");
constexpr int firstCount = 8, maxCount = 1000, minTile = 96, maxTile = 384, firstTile = 160;
constexpr int savedTile = 320, savedPdfTile = 120, maxSavedColumns = 6;

QString nameOf(const study::MeasuredRepresentation& one) {
  return QString::fromStdString(one.record.representation.shortLabel());
}

QString numbersOf(const study::StudyRecord& record) {
  const QString snr = StudySheet::tr("Rendered SNR %1 dB").arg(comparisonValue(record.renderedSnr));
  if (record.representation.kind->model)
    return StudySheet::tr("%1, %2 parameters").arg(snr).arg(record.bytes / sizeof(float));
  const QString size = QLocale().formattedDataSize(qint64(record.bytes), 1, QLocale::DataSizeSIFormat);
  if (std::isnan(record.frameMilliseconds)) return QStringLiteral("%1, %2").arg(snr, size);
  return StudySheet::tr("%1, %2, %3 per frame")
      .arg(snr, size, QString::fromStdString(study::shortQuantity(1e-3 * record.frameMilliseconds, "s")));
}

/// @param entry null: not measured.
widgets::SheetTile tileOf(const SheetPictures& pictures, const SheetEntry& entry) {
  if (!entry) return {.name = {}, .numbers = {}, .picture = {}, .map = {}, .note = StudySheet::tr("Not measured")};
  QPixmap picture = pictures.picture(entry);
  // Until then, the small image of the study.
  if (picture.isNull() && entry->picture.width > 0) picture = QPixmap::fromImage(displayedImage(entry->picture));
  return {.name = nameOf(*entry), .numbers = numbersOf(entry->record), .picture = picture, .map = pictures.map(entry)};
}

}  // namespace

widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control) {
  const auto table = studied.tabulated(control);
  return widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table));
}

StudySheet::StudySheet(BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent),
      m_tasks(tasks),
      m_pictures(tasks, nullptr),
      m_pairKey(QStringLiteral("study sheet %1 pair").arg(quintptr(this))),
      m_sheet(new widgets::ContactSheet),
      m_hint(new QLabel(m_sheet)) {
  build();
  connect(&m_pictures, &SheetPictures::changed, this, &StudySheet::showTiles);
  connect(&m_pictures, &SheetPictures::failed, this, &StudySheet::failed);
  showTiles();
}

StudySheet::~StudySheet() { m_tasks.drop(m_pairKey); }

void StudySheet::build() {
  const int em = fontMetrics().height();
  m_count = new QSpinBox;
  m_count->setRange(1, maxCount);
  m_count->setValue(firstCount);
  m_count->setToolTip(tr("Number of representations, in the order of the results"));
  m_maps = new QCheckBox(tr("Error ma&ps"));
  m_maps->setChecked(true);
  m_maps->setToolTip(tr("Shows the absolute luminance difference from the material, on one scale for all images"));
  auto* size = new QSlider(Qt::Horizontal);
  size->setRange(minTile, maxTile);
  size->setValue(firstTile);
  size->setFixedWidth(8 * em);
  size->setAccessibleName(tr("Image size"));
  size->setToolTip(size->accessibleName());
  m_compare = new QPushButton(tr("C&ompare in the Preview"));
  m_compare->setToolTip(tr("Select two images by clicking, or with the arrow keys and Space"));
  m_save = new QPushButton(tr("Sa&ve Image..."));
  m_save->setToolTip(tr("Saves the sheet as a PNG file"));
  m_savePdf = new QPushButton(tr("Save P&DF..."));
  m_savePdf->setToolTip(tr("Saves the sheet as a PDF file, with texts as text, for a paper"));
  auto* label = new QLabel(tr("Show &first"));
  label->setBuddy(m_count);
  auto* top = new QHBoxLayout;
  for (QWidget* widget : std::initializer_list<QWidget*>{label, m_count, m_maps, size}) top->addWidget(widget);
  top->addStretch();
  for (QPushButton* button : {m_compare, m_save, m_savePdf}) {
    button->setAutoDefault(false);
    top->addWidget(button);
  }
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_sheet);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusProxy(m_sheet);
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setForegroundRole(QPalette::PlaceholderText);
  auto* over = new QVBoxLayout(m_sheet);
  over->addWidget(m_hint);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(scroll, 1);
  connect(m_count, &QSpinBox::valueChanged, this,
          [this] { m_pictures.setSources(m_pictures.sources(), m_count->value()); });
  connect(m_maps, &QCheckBox::toggled, m_sheet, &widgets::ContactSheet::setMapsShown);
  connect(size, &QSlider::valueChanged, m_sheet, &widgets::ContactSheet::setTileSide);
  connect(m_compare, &QPushButton::clicked, this, &StudySheet::compareSelected);
  connect(m_save, &QPushButton::clicked, this, &StudySheet::save);
  connect(m_savePdf, &QPushButton::clicked, this, &StudySheet::savePdf);
  connect(m_sheet, &widgets::ContactSheet::selectionChanged, this, &StudySheet::showSelection);
}

void StudySheet::setSources(std::vector<SheetSource> sources) {
  m_pictures.setSources(std::move(sources), m_count->value());
}

void StudySheet::setHint(const QString& text) { m_hint->setText(text); }

void StudySheet::setCount(int count) { m_count->setValue(count); }

void StudySheet::showTiles() {
  std::vector<widgets::SheetTile> tiles;
  m_places.clear();
  const std::vector<SheetSource>& sources = m_pictures.sources();
  const bool isGrid = sources.size() > 1;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::vector<SheetEntry> shown = m_pictures.shown(i);
    columns = std::max(columns, shown.size() + 1);
    if (shown.empty()) continue;
    tiles.push_back({.name = widgets::spacedName(sources[i].name),
                     .numbers = m_pictures.kind(i),
                     .picture = m_pictures.reference(i),
                     .map = {}});
    m_places.push_back({i, -1});
    for (int entry = 0; entry < int(shown.size()); ++entry) {
      tiles.push_back(tileOf(m_pictures, shown[std::size_t(entry)]));
      m_places.push_back({i, entry});
    }
  }
  m_hint->setVisible(tiles.empty());
  m_sheet->setColumns(isGrid ? int(columns) : 0);
  m_sheet->setTiles(std::move(tiles));
  m_sheet->setRange(m_pictures.range());
  m_save->setEnabled(m_pictures.isComplete());
  m_savePdf->setEnabled(m_pictures.isComplete());
  showSelection();
}

void StudySheet::showSelection() {
  const std::vector<int> selected = m_sheet->selected();
  m_compare->setEnabled(selected.size() == 2 && std::ranges::all_of(selected, [this](int tile) {
                          const Place place = m_places[std::size_t(tile)];
                          return place.entry < 0 || m_pictures.shown(place.source)[std::size_t(place.entry)];
                        }));
}

widgets::PreviewSubject StudySheet::subjectOf(const SheetSource& source, int entry, const TaskControl& control) {
  if (entry >= 0 && !source.entries[std::size_t(entry)]->fit)
    return studiedSubject(*source.entries[std::size_t(entry)], control);
  const LoadedMaterialPtr material = materialOf(source, control);
  if (entry < 0) return widgets::measuredSubject(material->base, material->density);
  const fitting::FitResult& fit = *source.entries[std::size_t(entry)]->fit;
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(*material->base);
  const widgets::StandaloneModel model{fit.model, fit.parameters, table ? table->grid() : HalfDifferenceGrid()};
  return {model, material->density};
}

void StudySheet::compareSelected() {
  const std::vector<int> tiles = m_sheet->selected();
  const auto tileName = [this](int tile) { return m_sheet->tiles()[std::size_t(tile)].name; };
  const std::array<QString, 2> names{tileName(tiles[0]), tileName(tiles[1])};
  using Pair = std::array<widgets::PreviewSubject, 2>;
  const Place first = m_places[std::size_t(tiles[0])], second = m_places[std::size_t(tiles[1])];
  m_tasks.run<Pair>(
      {tr("Preparing %1 and %2").arg(names[0], names[1]), m_pairKey},
      [sources = m_pictures.sources(), first, second](const TaskControl& control) {
        return Pair{subjectOf(sources[first.source], first.entry, control.between(0, 0.5)),
                    subjectOf(sources[second.source], second.entry, control.between(0.5, 1))};
      },
      [this, names](const Pair& subjects) { Q_EMIT compareRequested(subjects, names); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot compare the representations"), error); });
}

QString StudySheet::proposedName(const QString& suffix) const {
  const std::vector<SheetSource>& sources = m_pictures.sources();
  const QString name = sources.size() == 1 ? sources[0].name + tr(" contact sheet") : tr("contact sheet");
  return widgets::inDialogFolder(pictureFolder, name + suffix);
}

void StudySheet::save() {
  const QString proposed = proposedName(QStringLiteral(".png"));
  widgets::askForPath(this, tr("Save Contact Sheet"), proposed, tr("PNG (*.png)"), [this](const QString& path) {
    widgets::rememberDialogFolder(pictureFolder, path);
    Q_EMIT saveRequested(path, m_sheet->picture(savedTile, savedColumns()));
  });
}

void StudySheet::savePdf() {
  const QString proposed = proposedName(QStringLiteral(".pdf"));
  widgets::askForPath(this, tr("Save Contact Sheet"), proposed, tr("PDF (*.pdf)"), [this](const QString& path) {
    widgets::rememberDialogFolder(pictureFolder, path);
    const QByteArray bytes = m_sheet->pdf(savedPdfTile, savedColumns());
    Q_EMIT writeRequested(path, {.write = [bytes](const std::filesystem::path& file, const TaskControl&) {
                            io::writeFileAtomically(file, std::as_bytes(std::span(bytes.constData(), bytes.size())));
                          }});
  });
}

/// Several materials have a row each.
int StudySheet::savedColumns() const {
  const int tiles = int(m_sheet->tiles().size());
  return m_sheet->columns() > 0 ? m_sheet->columns() : std::min(maxSavedColumns, tiles);
}

}  // namespace gonio::app

#include "moc_study_sheet.cpp"
