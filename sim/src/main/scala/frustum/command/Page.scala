package frustum.command

/** A page of a report of the laboratory. */
object Page {
  def apply(title: String, body: String): String =
    s"""<!doctype html>
       |<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
       |<title>$title</title>
       |<style>
       |:root { color-scheme: light dark }
       |body { margin: 0 auto; padding: 2rem; max-width: 74rem; font: 16px/1.5 system-ui, sans-serif }
       |table { border-collapse: collapse; font-variant-numeric: tabular-nums } th { text-align: left }
       |th, td { padding: .2rem 1rem; border-bottom: 1px solid #8884 } .over { background: #e334 }
       |img { max-width: 100% } figure { margin: 1rem 0 2rem } figcaption { opacity: .8 }
       |</style></head><body>
       |<h1>$title</h1>
       |$body
       |</body></html>
       |""".stripMargin
}
