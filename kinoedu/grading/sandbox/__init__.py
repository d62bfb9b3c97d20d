"""The sandbox: where students' programs run and can do no harm."""
