// VTK's legacy reader of unstructured grids does not free the cells that it had read when a file
// turns out to be cut.
#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:vtkCellArray::New\nleak:vtkUnstructuredGridReader::ReadMeshSimple\n";
}
#endif
