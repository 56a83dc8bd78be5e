// Counted by the query around this pass.
void main() {}
