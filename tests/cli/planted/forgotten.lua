return { nobody = "requires this" }
