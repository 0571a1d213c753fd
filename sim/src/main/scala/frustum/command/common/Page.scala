package frustum.command.common

import java.nio.file.{Files, Path}
import java.util.Base64

/** A page of a report of the laboratory. */
object Page {

  /** A PNG file as the source of an image within the page, so that the page can be sent and kept alone. */
  def source(png: Path): String =
    s"data:image/png;base64,${Base64.getEncoder.encodeToString(Files.readAllBytes(png))}"

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
