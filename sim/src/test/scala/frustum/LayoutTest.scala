package frustum

import java.nio.file.{Files, Path, Paths}
import org.scalatest.funsuite.AnyFunSuite
import scala.jdk.CollectionConverters._

/** The arrows between packages, read from the sources (imports, and names written out whole), and the size of files. */
class LayoutTest extends AnyFunSuite {

  /** `from` names something of `to`, in `file`. */
  private case class Arrow(from: String, to: String, file: Path)

  private val projects = Seq("hw/contract", "hw", "driver/scala", "boards/demos", "boards", "sim")

  private val sources: Seq[(Path, String, String)] = for {
    project <- projects
    file <- Files.walk(Paths.get(project, "src/main/scala")).iterator.asScala.toSeq.sorted
    if file.toString.endsWith(".scala")
  } yield {
    val text = Files.readString(file).replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("//[^\n]*", "")
    (file, "(?m)^package ([\\w.]+)".r.findFirstMatchIn(text).get.group(1), text)
  }

  private val packages = sources.map(_._2).toSet

  /** `frustum.a.b.C` and `import frustum.{a, b}`: the longest package that each begins with. */
  private def named(text: String): Iterator[String] = {
    val whole = "\\bfrustum(?:\\.\\w+)+".r.findAllIn(text)
    val braces = "import (frustum(?:\\.\\w+)*)\\.\\{([^}]*)\\}".r.findAllMatchIn(text)
      .flatMap(m => m.group(2).split(',').map(name => s"${m.group(1)}.${name.trim.takeWhile(!_.isWhitespace)}"))
    (whole ++ braces).flatMap(_.split('.').inits.map(_.mkString(".")).find(packages))
  }

  private val arrows: Seq[Arrow] = for {
    (file, from, text) <- sources
    to <- named(text).toSet
    if to != from
  } yield Arrow(from, to, file)

  private val next: Map[String, Seq[String]] = arrows.groupMap(_.from)(_.to).view.mapValues(_.distinct.sorted).toMap

  /** A way from a package back to itself, if there is one. */
  private def cycle(start: String): Option[Seq[String]] = {
    val seen = collection.mutable.Set.empty[String]
    def search(at: String): Option[List[String]] =
      next.getOrElse(at, Nil).iterator.flatMap { to =>
        if (to == start) Some(List(to)) else if (seen.add(to)) search(to).map(to :: _) else None
      }.nextOption()
    search(start).map(start +: _)
  }

  private val engines = Set("raster", "ray", "voxel")

  /** The engine of a package of `hw` or its contract; None for what engines share. */
  private def engine(name: String): Option[String] =
    name.stripPrefix("frustum.").stripPrefix("contract.").split('.').headOption.filter(engines)

  private val hardware = sources.collect { case (file, name, _) if file.startsWith("hw") => name }.toSet

  test("the sources are found") {
    assert(sources.size > 300 && arrows.size > 500)
    for ((file, name, _) <- sources) assert(file.getParent.endsWith(name.replace('.', '/')), file)
  }

  test("there is no cycle between packages") {
    assert(packages.toSeq.sorted.flatMap(cycle).isEmpty)
  }

  test("in hw nothing points from one engine to another, what is shared points to none") {
    val wrong = arrows.filter(a => hardware(a.from) && engine(a.to).isDefined && engine(a.from) != engine(a.to))
    assert(wrong.isEmpty)
  }

  test("hw points to nothing outside of hw") {
    assert(arrows.filter(a => hardware(a.from) && !hardware(a.to)).isEmpty)
  }

  test("no file of hw is longer than 220 lines") {
    val long = sources.filter(_._1.startsWith("hw")).map(s => s._1 -> Files.readAllLines(s._1).size).filter(_._2 > 220)
    assert(long.isEmpty)
  }

  test("no line of a Scala file has more than 120 columns") {
    val folders = projects.flatMap(project => Seq(s"$project/src/main/scala", s"$project/src/test/scala"))
    val files = for {
      folder <- folders.map(Paths.get(_)) if Files.exists(folder)
      file <- Files.walk(folder).iterator.asScala if file.toString.endsWith(".scala")
    } yield file
    assert(files.exists(_.startsWith("sim/src/test")) && files.size > 500)
    val long = for {
      file <- files
      (line, n) <- Files.readAllLines(file).asScala.zipWithIndex
      if line.codePointCount(0, line.length) > 120
    } yield s"$file:${n + 1}"
    assert(long.isEmpty)
  }
}
