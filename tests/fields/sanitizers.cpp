// VTK's legacy reader of unstructured grids does not free the cells that it had read when a file
// turns out to be cut.
#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:vtkCellArray::New\nleak:vtkUnstructuredGridReader::ReadMeshSimple\n";
}
#endif

// OpenVDB hands work to TBB, and neither library shows this sanitizer how its threads synchronize.
#if defined(__SANITIZE_THREAD__)
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() {
  return "called_from_lib:libtbb.so\ncalled_from_lib:libopenvdb.so\nrace:tbb::detail\n"
         "race:openvdb::*::io::\nrace:openvdb::*::tree::Tree\n"
         "mutex:DelayedLoadMetadata::unregisterType\nmutex:write_vdb\n";
}
#endif
