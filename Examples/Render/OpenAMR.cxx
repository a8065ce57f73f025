// SPDX-License-Identifier: BSD-3-Clause

#include "OpenAMR.h"

#include "Blocks.h"
#include "InputKind.h"
#include "Messages.h"

#include "vtkAMREnzoReader.h"
#include "vtkAMRFlashReader.h"
#include "vtkAMReXGridReader.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkExaBricksFileCheck.h"
#include "vtkExaBricksFirstPicture.h"
#include "vtkVersion.h"
#include "vtkXMLUniformGridAMRReader.h"

#ifdef EXABRICKS_RENDER_HAS_HDF
#include "vtkDataArraySelection.h"
#include "vtkHDFReader.h"
#endif

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>

namespace render
{

namespace
{

namespace fs = std::filesystem;

const int AllLevels = 1000000;

template <class ReaderType>
vtkSmartPointer<vtkAlgorithm> makeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<ReaderType>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

[[noreturn]] void Refuse(const std::string& message)
{
  throw Failure(ExitCode::InputUnreadable, message);
}

// Before a reader trusts what it says.
void refuseDamaged(const std::string& path)
{
  const std::string fault = vtkExaBricksFileCheck::FindFault(path);
  if (!fault.empty())
  {
    const bool mayBeWhole = fault.rfind("of a kind that is not read", 0) == 0;
    Refuse("'" + path + "' is damaged" + (mayBeWhole ? ", or " : ": ") + fault +
      ". Copy it anew, or write it once more.");
  }
}

vtkSmartPointer<vtkAlgorithm> readerFor(std::string path)
{
  // A slash at the end would stay in the names that the AMReX reader makes.
  while (path.size() > 1 && path.back() == '/')
  {
    path.pop_back();
  }
  const InputKind kind = findInputKind(path);
  refuseDamaged(path);
  switch (kind)
  {
    case InputKind::AMReX:
      return makeReader<vtkAMReXGridReader>(path);
    case InputKind::Enzo: // which looks for its files in the root folder, if none is said
      return makeReader<vtkAMREnzoReader>(fs::absolute(path).string());
    case InputKind::Flash:
      return makeReader<vtkAMRFlashReader>(path);
    case InputKind::VTKHDF:
#ifdef EXABRICKS_RENDER_HAS_HDF
      return makeReader<vtkHDFReader>(path);
#else
      Refuse("This build cannot read .vtkhdf files: VTK's module IOHDF was not there.");
#endif
    case InputKind::XML:
      break;
  }
  return makeReader<vtkXMLUniformGridAMRReader>(path);
}

// Switches cell arrays on, and the others off.
void selectOnly(
  vtkAlgorithm* reader, const std::vector<ArrayInfo>& arrays, const std::vector<std::string>& names)
{
  for (const ArrayInfo& array : arrays)
  {
    const int on = std::find(names.begin(), names.end(), array.Name) != names.end();
    if (auto* amr = vtkAMRBaseReader::SafeDownCast(reader))
    {
      amr->SetCellArrayStatus(array.Name.c_str(), on);
    }
    else if (auto* xml = vtkXMLReader::SafeDownCast(reader))
    {
      xml->SetCellArrayStatus(array.Name.c_str(), on);
    }
#ifdef EXABRICKS_RENDER_HAS_HDF
    else if (auto* hdf = vtkHDFReader::SafeDownCast(reader))
    {
      hdf->GetCellDataArraySelection()->SetArraySetting(array.Name.c_str(), on);
    }
#endif
  }
}

}

bool ArrayInfo::Varies() const
{
  const double largest = std::max(std::abs(this->Range[0]), std::abs(this->Range[1]));
  return this->Range[1] - this->Range[0] > 1e-6 * largest;
}

AMRFile::AMRFile(const std::string& path)
  : Path(path)
  , Reader(readerFor(path))
{
  this->RunReader([this] { this->Reader->UpdateInformation(); });
  throwIfErrors(ExitCode::InputUnreadable, "'" + path + "' could not be read");
  this->FindArrays();
}

AMRFile::~AMRFile() = default;

// VTK's readers believe what a header says of sizes, and throw where so much cannot be had.
void AMRFile::RunReader(const std::function<void()>& work) const
{
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    const std::string message = "'" + this->Path +
      "' could not be read: a header in it is damaged, or it takes more memory than there is (" +
      this->ReaderName() + " ended with " + error.what() +
      "). Check that it was copied whole; if it was, use --levels to read fewer levels, or a "
      "machine with more memory";
    throwIfErrors(ExitCode::InputUnreadable, message);
    Refuse(message + ".");
  }
}

const char* AMRFile::ReaderName() const { return this->Reader->GetClassName(); }

void AMRFile::SetLevels(int levels)
{
  if (auto* amr = vtkAMRBaseReader::SafeDownCast(this->Reader))
  {
    amr->SetMaxLevel(levels > 0 ? levels - 1 : AllLevels);
  }
  else if (auto* xml = vtkXMLUniformGridAMRReader::SafeDownCast(this->Reader))
  {
    xml->SetMaximumLevelsToReadByDefault(levels);
  }
#if defined(EXABRICKS_RENDER_HAS_HDF) && VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  else if (auto* hdf = vtkHDFReader::SafeDownCast(this->Reader))
  {
    hdf->SetMaximumLevelsToReadByDefaultForAMR(levels);
  }
#endif
}

void AMRFile::FindArrays()
{
  // The AMR readers list their arrays, but not how many components each has: some make vectors of
  // names that end in x, y, z. So the coarsest level is read once.
  auto* base = vtkAMRBaseReader::SafeDownCast(this->Reader);
  const auto enableAll = [base](int status)
  {
    for (int i = 0; base && i < base->GetNumberOfCellArrays(); ++i)
    {
      base->SetCellArrayStatus(base->GetCellArrayName(i), status);
    }
  };
  enableAll(1);
  this->SetLevels(1);
  this->RunReader([this] { this->Reader->Update(); });
  enableAll(0);
  auto amr = this->Output("could not be read");
  bool isFirst = true;
  forEachBlock(amr,
    [&](vtkDataSet* block)
    {
      vtkCellData* cells = block->GetCellData();
      for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* array = cells->GetArray(i);
        if (!array || !array->GetName() ||
          std::string(array->GetName()) == vtkDataSetAttributes::GhostArrayName())
        {
          continue;
        }
        double range[2];
        array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
        const auto known = std::find_if(this->CellArrays.begin(), this->CellArrays.end(),
          [&](const ArrayInfo& info) { return info.Name == array->GetName(); });
        if (known != this->CellArrays.end())
        {
          known->Range[0] = std::min(known->Range[0], range[0]);
          known->Range[1] = std::max(known->Range[1], range[1]);
        }
        else if (isFirst) // all blocks have its arrays
        {
          this->CellArrays.push_back(
            { array->GetName(), array->GetNumberOfComponents(), { range[0], range[1] } });
        }
      }
      isFirst = false;
    });
}

vtkSmartPointer<vtkOverlappingAMR> AMRFile::Output(const std::string& doing) const
{
  throwIfErrors(ExitCode::InputUnreadable, "'" + this->Path + "' " + doing);
  vtkDataObject* output = this->Reader->GetOutputDataObject(0);
  vtkSmartPointer<vtkOverlappingAMR> amr = vtkOverlappingAMR::SafeDownCast(output);
  if (!amr)
  {
    std::string text = "'" + this->Path + "' is not overlapping AMR: VTK " +
      vtkVersion::GetVTKVersion() + " read a " + (output ? output->GetClassName() : "nothing") +
      " from it.";
    if (fs::path(this->Path).extension() == ".vtkhdf")
    {
      text += " AMR in .vtkhdf files needs VTK 9.3 or later.";
    }
    Refuse(text);
  }
  return amr;
}

vtkSmartPointer<vtkOverlappingAMR> AMRFile::Read(const std::string& array, int levels, bool quiet)
{
  Progress progress("Reading " + this->Path, quiet);
  progress.Follow(this->Reader);
  this->SetLevels(levels);
  std::vector<std::string> read{ array };
  for (const ArrayInfo& info : this->CellArrays)
  {
    if (vtkExaBricksFirstPicture::IsVolumeFraction(info.Name))
    {
      read.push_back(info.Name);
    }
  }
  selectOnly(this->Reader, this->CellArrays, read);
  this->RunReader([this] { this->Reader->Update(); });
  auto amr = this->Output("could not be read");
  bool empty = true;
  forEachBlock(amr, [&empty](vtkDataSet*) { empty = false; });
  if (empty)
  {
    Refuse("'" + this->Path + "' holds no blocks: there is nothing to draw.");
  }
  if (!vtkExaBricksFirstPicture::IsVolumeFraction(array))
  {
    vtkExaBricksFirstPicture::HideCoveredCells(amr);
  }
  return amr;
}

}
